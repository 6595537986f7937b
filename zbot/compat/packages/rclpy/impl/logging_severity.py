"""Severities of log lines."""

from zbot.log import LoggingSeverity
