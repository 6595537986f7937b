# Written by python -m zbot.compat.generator; do not edit.
"""Severities of log lines."""

from zbot.log import LoggingSeverity

__all__ = [
    "LoggingSeverity",
]
