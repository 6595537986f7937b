"""Classes of rclpy that filter log calls, for programs that use these classes directly.

zbot's own loggers store the state of each filter, e.g. of `once=True`, for each line of code that
logs (`zbot.log.call_site`). The classes here have the same rules, but they store the state in a
dictionary of the caller, which is the `context`.
"""

from __future__ import annotations

import sys
from collections import OrderedDict
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple, TypedDict

from zbot.errors.call_source import OWN_FILES
from zbot.executor.clock import Clock
from zbot.log.errors import log_option_error, not_a_clock_error

if TYPE_CHECKING:
    from types import FrameType

    from zbot.log import LoggingSeverity

SupportedFiltersKeys = Literal["throttle", "skip_first", "once"]


class RcutilsLoggerContext(TypedDict):
    """Context of a log call, with the filters that the call uses."""

    name: str
    severity: LoggingSeverity
    filters: list[SupportedFiltersKeys]


class OnceContext(RcutilsLoggerContext):
    """Context of a log call that logs only once."""

    has_been_logged_once: bool


class ThrottleContext(RcutilsLoggerContext):
    """Context of a log call that is throttled."""

    throttle_duration_sec: float
    throttle_time_source_type: Clock
    throttle_last_logged: int  #: time of the last logged line, in nanoseconds


class SkipFirstContext(RcutilsLoggerContext):
    """Context of a log call that is skipped the first time."""

    first_has_been_skipped: bool


class LoggingFilterArgs(TypedDict, total=False):
    """Options of log calls that belong to filters."""

    once: bool
    throttle_duration_sec: float
    throttle_time_source_type: Clock
    skip_first: bool


class LoggingFilterParams(TypedDict, total=False):
    """Options of a filter and their defaults. `None` means that an option has no default."""

    once: bool | None
    throttle_duration_sec: float | None
    throttle_time_source_type: Clock
    skip_first: bool | None


class LoggingArgs(LoggingFilterArgs, total=False):
    """All options of log calls."""

    name: str


class _CallerId(NamedTuple):
    function_name: str
    file_path: str
    line_number: int
    last_index: int  #: distinguishes calls on the same line


class CallerId(_CallerId):
    """Line of code that logs. It is in the given frame, or in the innermost frame outside zbot."""

    __slots__ = ()

    def __new__(cls, frame: FrameType | None = None) -> CallerId:
        """Find the line of code."""
        found = frame or sys._getframe(1)  # noqa: SLF001 - inspect's way takes 100 times as long
        while frame is None and found.f_code.co_filename.startswith(OWN_FILES) and found.f_back:
            found = found.f_back
        code = found.f_code
        path = str(Path(code.co_filename).absolute())
        return super().__new__(cls, code.co_name, path, found.f_lineno, found.f_lasti)


class LoggingFilter:
    """Base class of the filters. This class itself skips no calls."""

    #: Options of the filter and their defaults. An option whose default is `None` is required.
    params: ClassVar[LoggingFilterParams] = {}

    @classmethod
    def initialize_context(cls, context: Any, **kwargs: Any) -> None:
        """Add the filter's options to a call's context.

        Raises:
            WrongTypeError: A required option is missing.
        """
        for name, default in cls.params.items():
            value = kwargs.get(name, default)
            if value is None:
                raise log_option_error(name, f"is missing, and the filter {cls.__name__} needs it")
            context[name] = value

    @staticmethod
    def should_log(context: Any) -> bool:  # noqa: ARG004 - the other filters use it
        """Return whether the call may log now, and store in the context that it was called."""
        return True


class Once(LoggingFilter):
    """Filter that skips every call after the first call."""

    params: ClassVar[LoggingFilterParams] = {"once": None}

    @classmethod
    def initialize_context(cls, context: Any, **kwargs: Any) -> None:
        """Add the filter's options to a call's context, and store that the call has not logged."""
        super().initialize_context(context, **kwargs)
        context["has_been_logged_once"] = False

    @staticmethod
    def should_log(context: Any) -> bool:
        """Return whether this is the first call."""
        logged, context["has_been_logged_once"] = context["has_been_logged_once"], True
        return not logged


class Throttle(LoggingFilter):
    """Filter that skips all calls within the throttle duration after a logged line."""

    params: ClassVar[LoggingFilterParams] = {
        "throttle_duration_sec": None,
        "throttle_time_source_type": Clock(),
    }

    @classmethod
    def initialize_context(cls, context: Any, **kwargs: Any) -> None:
        """Add the filter's options to a call's context, and store that the call has not logged.

        Raises:
            WrongValueError: `throttle_time_source_type` is not a clock.
        """
        super().initialize_context(context, **kwargs)
        context["throttle_last_logged"] = 0
        clock = context["throttle_time_source_type"]
        if not isinstance(clock, Clock):
            raise not_a_clock_error("throttle_time_source_type", clock)

    @staticmethod
    def should_log(context: Any) -> bool:
        """Return whether the throttle duration since the last logged line is over."""
        now = context["throttle_time_source_type"].now().nanoseconds
        is_open: bool = (
            now >= context["throttle_last_logged"] + context["throttle_duration_sec"] * 1e9
        )
        if is_open:
            context["throttle_last_logged"] = now
        return is_open


class SkipFirst(LoggingFilter):
    """Filter that skips the first call."""

    params: ClassVar[LoggingFilterParams] = {"skip_first": None}

    @classmethod
    def initialize_context(cls, context: Any, **kwargs: Any) -> None:
        """Add the filter's options to a call's context, and store that no call was skipped."""
        super().initialize_context(context, **kwargs)
        context["first_has_been_skipped"] = False

    @staticmethod
    def should_log(context: Any) -> bool:
        """Return False for the first call, and True for every later call."""
        skipped: bool = context["first_has_been_skipped"]
        context["first_has_been_skipped"] = True
        return skipped


#: The filters, in the order in which they are applied. The keys are their names.
supported_filters: OrderedDict[SupportedFiltersKeys, type[LoggingFilter]] = OrderedDict()
supported_filters["throttle"] = Throttle
supported_filters["skip_first"] = SkipFirst
supported_filters["once"] = Once


def get_filters_from_kwargs(**kwargs: Any) -> list[SupportedFiltersKeys]:
    """Return the names of the filters that the options of a log call enable.

    Raises:
        WrongTypeError: An option is unknown, or a required option is missing.
    """
    known = [name for filter_ in supported_filters.values() for name in filter_.params]
    for name in kwargs:
        if name not in known:
            raise log_option_error(
                name, f"is not one of the recognized ones: use {', '.join(known)}"
            )
    found: list[SupportedFiltersKeys] = [
        key for key, filter_ in supported_filters.items() if any(map(kwargs.get, filter_.params))
    ]
    for key in found:
        for name, default in supported_filters[key].params.items():
            if default is None and name not in kwargs:
                raise log_option_error(name, f"is missing, and the filter {key} needs it")
    return found
