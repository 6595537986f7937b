"""The log of a launch by the names of `launch.logging`."""

from __future__ import annotations

import logging
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from zbot.log.log_file import get_logging_directory

_FORM = "[%(levelname)s] [%(name)s]: %(message)s"


if TYPE_CHECKING:
    _StreamHandler = logging.StreamHandler[TextIO]
else:
    _StreamHandler = logging.StreamHandler  # no generic class before Python 3.11


class _ScreenHandler(_StreamHandler):
    """Writes to what is stdout now: tests and programs replace it."""

    def emit(self, record: logging.LogRecord) -> None:
        self.setStream(sys.stdout)
        super().emit(record)


class LaunchConfig:
    """What can be set about the log of a launch."""

    def __init__(self) -> None:
        self.level = logging.INFO
        self.log_handler_factory: object = None

    @property
    def log_dir(self) -> str:
        """The folder that log folders are made in."""
        return str(get_logging_directory())

    @log_dir.setter
    def log_dir(self, folder: str) -> None:
        os.environ["ZBOT_LOG_DIR"] = str(folder)  # the processes of the launch follow, too

    def get_log_file_path(self, file_name: str = "launch.log") -> str:
        """Return the path of a log file."""
        return str(Path(self.log_dir) / file_name)


launch_config = LaunchConfig()


def get_logger(name: str | None = None) -> logging.Logger:
    """Return a logger that writes to the screen in ROS 2's form."""
    logger = logging.getLogger(name or "launch")
    if not any(isinstance(handler, _ScreenHandler) for handler in logger.handlers):
        handler = _ScreenHandler()
        handler.setFormatter(logging.Formatter(_FORM))
        logger.addHandler(handler)
        logger.setLevel(launch_config.level)
        logger.propagate = False
    return logger
