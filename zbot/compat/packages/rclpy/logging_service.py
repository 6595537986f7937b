# Written by python -m zbot.compat.generator; do not edit.
"""Services for the levels of loggers."""

from zbot.log import LoggingSeverity
from zbot.node.logger_services import LoggingService
from zbot.qos import qos_profile_services_default
from rcl_interfaces.msg import LoggerLevel, SetLoggerLevelsResult
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from zbot.compat.constants import TOPIC_SEPARATOR_STRING

__all__ = [
    "GetLoggerLevels",
    "LoggerLevel",
    "LoggingService",
    "LoggingSeverity",
    "SetLoggerLevels",
    "SetLoggerLevelsResult",
    "TOPIC_SEPARATOR_STRING",
    "qos_profile_services_default",
]
