"""What processes wrote."""

from zbot.launch_test.record import OutputRecord as ActiveIoHandler
from zbot.launch_test.record import OutputRecord as IoHandler
