"""Loggers."""

from zbot.clock import Clock as Clock
from zbot.log import Logger as RcutilsLogger
from zbot.log import LoggingSeverity as LoggingSeverity
