"""Exception hooks for processes in which `zbot run` runs a program.

A program that is started in another way, e.g. with `python`, keeps its own hooks. Without any, it
gets advice for its errors (see `zbot.process.error_advice`).
"""

from __future__ import annotations

import sys
import threading
from types import TracebackType
from typing import Any

from zbot.errors import ExternalShutdownException, SetupError
from zbot.errors.call_source import OWN_FILES
from zbot.interfaces.unknown_field import add_advice
from zbot.process import at_exit, signals
from zbot.process.attribute_advice import (
    advise_of_attribute,
    advise_of_import,
    suggest_public_name,
)
from zbot.process.call_advice import advise_of_call
from zbot.text.typographic import advise_of_syntax
from zbot.threads.foreign_call import defers_signals


def install() -> None:
    """Let tracebacks begin in the user's code, and print a `SetupError` without a traceback.

    If Python drops the exception of a signal in a destructor, the signal is sent again.
    """
    sys.excepthook = _excepthook_before(sys.excepthook)
    threading.excepthook = _thread_hook_before(threading.excepthook)
    sys.unraisablehook = _unraisablehook_before(sys.unraisablehook)


def _excepthook_before(previous: Any) -> Any:
    """Return a hook that prints no traceback for a `SetupError` or a shutdown.

    The hook gives other exceptions to `previous`.
    """

    def excepthook(
        kind: type[BaseException], value: BaseException, trace: TracebackType | None
    ) -> None:
        if issubclass(kind, SetupError):
            print(value, file=sys.stderr)
        elif not issubclass(kind, (ExternalShutdownException, KeyboardInterrupt)):
            _remove_zbot_frames(value)
            advise(value)
            previous(kind, value, value.__traceback__ or trace)

    return excepthook


def advise(value: BaseException) -> None:
    """Add to the text of a typical mistake what to write."""
    advise_of_call(value)
    advise_of_attribute(value)
    advise_of_import(value)
    add_advice(value)
    suggest_public_name(value)
    advise_of_syntax(value)


def _thread_hook_before(previous: Any) -> Any:
    """Return a hook that prints no traceback for a shutdown in a thread."""

    def thread_hook(args: threading.ExceptHookArgs) -> None:
        if not issubclass(args.exc_type, (ExternalShutdownException, KeyboardInterrupt)):
            _remove_zbot_frames(args.exc_value)
            if args.exc_value is not None:
                advise(args.exc_value)
            previous(args)

    return thread_hook


def _unraisablehook_before(previous: Any) -> Any:
    """Return a hook that sends a signal again if its exception was lost in a destructor."""

    @defers_signals  # the exception of a second signal would be printed as an error of this hook
    def unraisablehook(args: Any) -> None:
        is_lost = isinstance(args.exc_value, signals.SignalExit) and not at_exit.is_ending()
        if is_lost and sys.platform != "win32":
            signals.send_again(args.exc_value.number)
        else:
            previous(args)

    return unraisablehook


def _remove_zbot_frames(value: BaseException | None) -> None:
    # The exception's own traceback is changed, because Python prints this traceback, and not the
    # traceback that a hook gives to the next hook.
    if value is not None:
        value.__traceback__ = user_traceback(value.__traceback__)


def user_traceback(trace: TracebackType | None) -> TracebackType | None:
    """Return a traceback without zbot's frames. A callback's traceback begins in the callback.

    If all frames are zbot's, the traceback is returned as it is, because it shows an error in zbot.
    """
    kept: list[TracebackType] = []
    entry = trace
    while entry is not None:
        if not _is_ours(entry):
            kept.append(entry)
        elif entry.tb_next is not None and not _is_ours(entry.tb_next):
            kept.clear()  # a callback begins, so the frames before it are of no use
        entry = entry.tb_next
    result: TracebackType | None = None
    for entry in reversed(kept):
        result = TracebackType(result, entry.tb_frame, entry.tb_lasti, entry.tb_lineno)
    return result or trace


def _is_ours(entry: TracebackType) -> bool:
    return entry.tb_frame.f_code.co_filename.startswith(OWN_FILES)
