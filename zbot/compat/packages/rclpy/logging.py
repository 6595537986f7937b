# Written by python -m zbot.compat.generator; do not edit.
"""Loggers and their levels."""

from zbot.compat.root_logger import initialize, root_logger as _root_logger
from zbot.log import (
    Logger as RcutilsLogger,
    LoggingSeverity,
    clear_config,
    clear_config as shutdown,
    get_logger,
    get_logger_effective_level,
    get_logger_level,
    get_logging_directory,
    get_logging_severity_from_string,
    set_logger_level,
)

__all__ = [
    "LoggingSeverity",
    "RcutilsLogger",
    "clear_config",
    "get_logger",
    "get_logger_effective_level",
    "get_logger_level",
    "get_logging_directory",
    "get_logging_severity_from_string",
    "initialize",
    "set_logger_level",
    "shutdown",
]
