"""Log lines as ROS 2 writes them: on the console, in a file when asked, and to sinks.

    get_logger("sensor").info("ready", once=True)
    [INFO] [1700000000.123456789] [sensor]: ready

Levels are inherited by the dots of a logger's name. A sink gets every line of a logger and its
children as a `Record`: that is how a node publishes them on `/rosout`.
"""

from __future__ import annotations

from zbot.log.call_site import TimeProvider as TimeProvider
from zbot.log.log_file import get_logging_directory as get_logging_directory
from zbot.log.logger import Logger as Logger
from zbot.log.logger import get_logger as get_logger
from zbot.log.record import Record as Record
from zbot.log.registry import HUB as _HUB
from zbot.log.severity import LoggingSeverity as LoggingSeverity
from zbot.log.severity import get_logging_severity_from_string as get_logging_severity_from_string

add_sink = _HUB.add_sink
away_from_sinks = _HUB.away_from_sinks
clear_config = _HUB.clear_config
configure = _HUB.configure
get_logger_effective_level = _HUB.get_logger_effective_level
get_logger_level = _HUB.get_logger_level
remove_sink = _HUB.remove_sink
set_logger_level = _HUB.set_logger_level

__all__ = [
    "Logger",
    "LoggingSeverity",
    "Record",
    "TimeProvider",
    "add_sink",
    "away_from_sinks",
    "clear_config",
    "configure",
    "get_logger",
    "get_logger_effective_level",
    "get_logger_level",
    "get_logging_directory",
    "get_logging_severity_from_string",
    "remove_sink",
    "set_logger_level",
]
