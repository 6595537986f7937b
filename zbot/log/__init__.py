"""Loggers that write lines in ROS 2's format to the console, to a log file and to sinks.

    get_logger("sensor").info("ready", once=True)
    [INFO] [1700000000.123456789] [sensor]: ready

A logger inherits the level of its parent: `a` is the parent of `a.b`. A sink gets every line of a
logger and its children as a `Record`. A node has a sink that publishes the records on `/rosout`.
"""

from __future__ import annotations

from zbot.log.call_site import TimeProvider as TimeProvider
from zbot.log.log_file import get_logging_directory as get_logging_directory
from zbot.log.logger import Logger as Logger
from zbot.log.logger import get_logger as get_logger
from zbot.log.logger import warn_once as warn_once
from zbot.log.record import LoggingSeverity as LoggingSeverity
from zbot.log.record import Record as Record
from zbot.log.record import get_logging_severity_from_string as get_logging_severity_from_string
from zbot.log.registry import REGISTRY as _REGISTRY

add_sink = _REGISTRY.add_sink
sinks_disabled = _REGISTRY.sinks_disabled
clear_config = _REGISTRY.clear_config
configure = _REGISTRY.configure
get_logger_effective_level = _REGISTRY.get_logger_effective_level
get_logger_level = _REGISTRY.get_logger_level
remove_sink = _REGISTRY.remove_sink
set_logger_level = _REGISTRY.set_logger_level

__all__ = [
    "Logger",
    "LoggingSeverity",
    "Record",
    "TimeProvider",
    "add_sink",
    "clear_config",
    "configure",
    "get_logger",
    "get_logger_effective_level",
    "get_logger_level",
    "get_logging_directory",
    "get_logging_severity_from_string",
    "remove_sink",
    "set_logger_level",
    "sinks_disabled",
    "warn_once",
]
