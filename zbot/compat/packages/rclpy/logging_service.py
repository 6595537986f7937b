"""Levels of loggers as services."""

from zbot.log import LoggingSeverity as LoggingSeverity
from zbot.node.logger_services import LoggingService as LoggingService
from zbot.qos import qos_profile_services_default as qos_profile_services_default

from rcl_interfaces.msg import LoggerLevel as LoggerLevel
from rcl_interfaces.msg import SetLoggerLevelsResult as SetLoggerLevelsResult
from rcl_interfaces.srv import GetLoggerLevels as GetLoggerLevels
from rcl_interfaces.srv import SetLoggerLevels as SetLoggerLevels

TOPIC_SEPARATOR_STRING = "/"
