"""Loggers."""

from zbot.compat.log_filter import CallerId as CallerId
from zbot.compat.log_filter import LoggingArgs as LoggingArgs
from zbot.compat.log_filter import LoggingFilter as LoggingFilter
from zbot.compat.log_filter import LoggingFilterArgs as LoggingFilterArgs
from zbot.compat.log_filter import LoggingFilterParams as LoggingFilterParams
from zbot.compat.log_filter import Once as Once
from zbot.compat.log_filter import OnceContext as OnceContext
from zbot.compat.log_filter import RcutilsLoggerContext as RcutilsLoggerContext
from zbot.compat.log_filter import SkipFirst as SkipFirst
from zbot.compat.log_filter import SkipFirstContext as SkipFirstContext
from zbot.compat.log_filter import SupportedFiltersKeys as SupportedFiltersKeys
from zbot.compat.log_filter import Throttle as Throttle
from zbot.compat.log_filter import ThrottleContext as ThrottleContext
from zbot.compat.log_filter import get_filters_from_kwargs as get_filters_from_kwargs
from zbot.compat.log_filter import supported_filters as supported_filters
from zbot.executor.clock import Clock as Clock
from zbot.log import Logger as RcutilsLogger
from zbot.log import LoggingSeverity as LoggingSeverity
