"""The root logger and the start of logging, as in `rclpy.logging`."""

from __future__ import annotations

from zbot.log import Logger

root_logger = Logger()


def initialize() -> None:
    """Do nothing, because logging begins with the first line, also after `shutdown()`."""
