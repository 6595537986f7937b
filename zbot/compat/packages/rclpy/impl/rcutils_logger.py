"""Loggers."""

from zbot.compat.logging_filters import CallerId as CallerId
from zbot.compat.logging_filters import LoggingArgs as LoggingArgs
from zbot.compat.logging_filters import LoggingFilter as LoggingFilter
from zbot.compat.logging_filters import LoggingFilterArgs as LoggingFilterArgs
from zbot.compat.logging_filters import LoggingFilterParams as LoggingFilterParams
from zbot.compat.logging_filters import Once as Once
from zbot.compat.logging_filters import OnceContext as OnceContext
from zbot.compat.logging_filters import RcutilsLoggerContext as RcutilsLoggerContext
from zbot.compat.logging_filters import SkipFirst as SkipFirst
from zbot.compat.logging_filters import SkipFirstContext as SkipFirstContext
from zbot.compat.logging_filters import SupportedFiltersKeys as SupportedFiltersKeys
from zbot.compat.logging_filters import Throttle as Throttle
from zbot.compat.logging_filters import ThrottleContext as ThrottleContext
from zbot.compat.logging_filters import get_filters_from_kwargs as get_filters_from_kwargs
from zbot.compat.logging_filters import supported_filters as supported_filters
from zbot.executor.clock import Clock as Clock
from zbot.log import Logger as RcutilsLogger
from zbot.log import LoggingSeverity as LoggingSeverity
