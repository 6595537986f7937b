"""Levels of loggers as services, which zbot does not have."""

from zbot.log import LoggingSeverity as LoggingSeverity
from zbot.logger_services import LoggingService as LoggingService
from zbot.qos import qos_profile_services_default as qos_profile_services_default

TOPIC_SEPARATOR_STRING = "/"
