"""What processes wrote."""

from zbot.launch.testing.record import OutputRecord as ActiveIoHandler
from zbot.launch.testing.record import OutputRecord as IoHandler
