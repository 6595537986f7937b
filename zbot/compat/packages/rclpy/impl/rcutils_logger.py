# Written by python -m zbot.compat.generator; do not edit.
"""Loggers."""

from zbot.compat.logging_filters import (
    CallerId,
    LoggingArgs,
    LoggingFilter,
    LoggingFilterArgs,
    LoggingFilterParams,
    Once,
    OnceContext,
    RcutilsLoggerContext,
    SkipFirst,
    SkipFirstContext,
    SupportedFiltersKeys,
    Throttle,
    ThrottleContext,
    get_filters_from_kwargs,
    supported_filters,
)
from zbot.executor.clock import Clock
from zbot.log import Logger as RcutilsLogger, LoggingSeverity

__all__ = [
    "CallerId",
    "Clock",
    "LoggingArgs",
    "LoggingFilter",
    "LoggingFilterArgs",
    "LoggingFilterParams",
    "LoggingSeverity",
    "Once",
    "OnceContext",
    "RcutilsLogger",
    "RcutilsLoggerContext",
    "SkipFirst",
    "SkipFirstContext",
    "SupportedFiltersKeys",
    "Throttle",
    "ThrottleContext",
    "get_filters_from_kwargs",
    "supported_filters",
]
