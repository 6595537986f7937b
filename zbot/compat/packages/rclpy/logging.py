"""Loggers and their levels."""

from zbot.log import Logger as RcutilsLogger
from zbot.log import LoggingSeverity as LoggingSeverity
from zbot.log import clear_config as clear_config
from zbot.log import clear_config as shutdown
from zbot.log import get_logger as get_logger
from zbot.log import get_logger_effective_level as get_logger_effective_level
from zbot.log import get_logger_level as get_logger_level
from zbot.log import get_logging_directory as get_logging_directory
from zbot.log import get_logging_severity_from_string as get_logging_severity_from_string
from zbot.log import set_logger_level as set_logger_level

_root_logger = RcutilsLogger()


def initialize() -> None:
    """Do nothing: logging begins with the first line, also after `shutdown()`."""
