"""Outputs of processes."""

from zbot.launch.testing.record import OutputRecord as ActiveIoHandler
from zbot.launch.testing.record import OutputRecord as IoHandler
