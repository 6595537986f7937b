"""Loggers and their levels."""

from zbot.log import Logger as RcutilsLogger
from zbot.log import (
    LoggingSeverity,
    clear_config,
    get_logger,
    get_logger_effective_level,
    get_logger_level,
    get_logging_directory,
    get_logging_severity_from_string,
    set_logger_level,
)
from zbot.log import clear_config as shutdown

_root_logger = RcutilsLogger()


def initialize() -> None:
    """Do nothing, because logging begins with the first line, also after `shutdown()`."""
