"""Every way out of a process closes its Zenoh sessions: the end of main, exceptions, signals.

A session left open with a subscriber keeps Python from ending at all, so this is not a nicety.
Ctrl-C raises `KeyboardInterrupt` as always, SIGTERM raises `ExternalShutdownException` in a
spinning main thread and `SystemExit` elsewhere; none of them prints a traceback when nobody catches
it.
"""

from __future__ import annotations

import atexit
import contextlib
import enum
import os
import signal
import sys
import threading
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Protocol

from zbot.errors import ExternalShutdownException, NotInitializedError, SetupError
from zbot.process import at_exit
from zbot.transport.foreign_call import is_uninterrupted
from zbot.transport.weak_set import WeakSet

if TYPE_CHECKING:
    from types import FrameType

_PACKAGE = str(Path(__file__).parents[1]) + os.sep
_TERMINATED = 128 + signal.SIGTERM
_MOMENT_S = 0.005  # longer than what Zenoh calls takes, and than a thread's start


class SignalHandlerOptions(enum.Enum):
    """Which signals `init()` handles."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


class GuardCondition(Protocol):
    """What a signal triggers."""

    def trigger(self) -> None:
        """Wake up whoever waits for it; from any thread."""


#: The guard conditions that Ctrl-C and SIGTERM trigger.
guard_conditions: WeakSet[GuardCondition] = WeakSet()


class _Process:
    """What this process has installed, and how it ends."""

    previous: dict[int, Any] = {}  # noqa: RUF012 - one per process
    hooked = False
    got_sigterm = False
    dies_of_sigterm = False


class MainThread:
    """What the signal handlers know about the main thread."""

    spins = 0  #: how many executors spin in it, each in a callback of the one before


def install(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Handle signals (main thread only: Python allows it nowhere else) and hook the ways out."""
    _hook_ways_out()
    if threading.current_thread() is not threading.main_thread():
        return
    if options in {SignalHandlerOptions.SIGINT, SignalHandlerOptions.ALL}:
        _replace(signal.SIGINT, _on_sigint)
    if options in {SignalHandlerOptions.SIGTERM, SignalHandlerOptions.ALL}:
        _replace(signal.SIGTERM, _on_sigterm)


def uninstall() -> None:
    """Give the signals back to whoever had them before `install()`."""
    if threading.current_thread() is threading.main_thread():
        for number, handler in _Process.previous.items():
            signal.signal(number, handler)
        _Process.previous.clear()


def installed() -> SignalHandlerOptions:
    """Return which signals are handled now."""
    own = (signal.SIGINT in _Process.previous) + 2 * (signal.SIGTERM in _Process.previous)
    return SignalHandlerOptions(own)


def _replace(number: int, handler: Any) -> None:
    present = signal.getsignal(number)
    if present is not handler:
        _Process.previous[number] = present if present is not None else signal.SIG_DFL
        signal.signal(number, handler)


def _interrupt_contexts() -> None:
    for context in at_exit.open_contexts:
        context.interrupt()
    if guard_conditions:
        # In a thread: who waits for one may hold its lock, and be what this signal interrupted.
        threading.Thread(target=_trigger_guards, daemon=True).start()


def _trigger_guards() -> None:
    for guard in guard_conditions:
        guard.trigger()


def _is_postponed(number: int, frame: FrameType | None) -> bool:
    """Return whether no exception may come here; the signal comes again in a moment then."""
    if not is_uninterrupted(frame):
        return False
    again = threading.Timer(_MOMENT_S, _signal_main_thread, [number])
    again.daemon = True
    again.start()
    return True


def _signal_main_thread(number: int) -> None:
    """Send a signal that also ends what the main thread is sleeping in."""
    if sys.platform == "win32":
        signal.raise_signal(number)
    else:
        signal.pthread_kill(threading.main_thread().ident or 0, number)


def _on_sigint(number: int, frame: FrameType | None) -> None:
    if at_exit.is_ending():
        return
    if _is_postponed(number, frame):
        return
    _interrupt_contexts()
    previous = _Process.previous.get(number)
    if callable(previous) and previous is not signal.default_int_handler:
        previous(number, frame)
        return
    raise KeyboardInterrupt


def _on_sigterm(number: int, frame: FrameType | None) -> None:
    if at_exit.is_ending():
        return
    if _is_postponed(number, frame):
        return
    _interrupt_contexts()
    previous = _Process.previous.get(number)
    if callable(previous):
        previous(number, frame)
        return
    _Process.got_sigterm = True
    if MainThread.spins:
        raise ExternalShutdownException
    _Process.dies_of_sigterm = True
    raise SystemExit(_TERMINATED)


def _hook_ways_out() -> None:
    if _Process.hooked:
        return
    _Process.hooked = True
    sys.excepthook = _quiet(sys.excepthook)
    thread_hook = threading.excepthook

    def on_thread_exception(args: threading.ExceptHookArgs) -> None:
        quiet: tuple[type[BaseException], ...] = (ExternalShutdownException, KeyboardInterrupt)
        if at_exit.is_ending():
            quiet += (NotInitializedError,)  # the thread used what was closed under it
        if not issubclass(args.exc_type, quiet):
            _shorten(args.exc_value)
            thread_hook(args)

    threading.excepthook = on_thread_exception
    sys.unraisablehook = _again(sys.unraisablehook)
    at_exit.hook()
    atexit.register(_die_of_sigterm)


def _quiet(previous: Any) -> Any:
    def excepthook(
        kind: type[BaseException], value: BaseException, trace: TracebackType | None
    ) -> None:
        if issubclass(kind, SetupError):
            print(value, file=sys.stderr)
        elif issubclass(kind, ExternalShutdownException):
            _Process.dies_of_sigterm = _Process.got_sigterm  # nobody caught it
        elif not issubclass(kind, KeyboardInterrupt):
            _shorten(value)
            previous(kind, value, value.__traceback__ or trace)

    return excepthook


def _again(previous: Any) -> Any:
    """Repeat a signal whose exception ended in a destructor, where Python drops it."""

    def unraisablehook(args: Any) -> None:
        number = signal.SIGINT if args.exc_type is KeyboardInterrupt else signal.SIGTERM
        ours = (KeyboardInterrupt, ExternalShutdownException, SystemExit)
        if at_exit.is_ending() or sys.platform == "win32" or not issubclass(args.exc_type, ours):
            previous(args)
        else:
            # The process may have come to its end: what the signal asked for is under way.
            with contextlib.suppress(RuntimeError):
                threading.Timer(_MOMENT_S, _signal_main_thread, [number]).start()

    return unraisablehook


def _shorten(value: BaseException | None) -> None:
    # Python prints the exception's own traceback, whatever a hook is given beside it.
    if value is not None:
        value.__traceback__ = user_part(value.__traceback__)


def user_part(trace: TracebackType | None) -> TracebackType | None:
    """Return a traceback without zbot's frames: a callback's begins at its own first line.

    What is all zbot's is returned whole: that is a fault of zbot.
    """
    kept: list[TracebackType] = []
    entry = trace
    while entry is not None:
        if not _is_ours(entry):
            kept.append(entry)
        elif entry.tb_next is not None and not _is_ours(entry.tb_next):
            kept.clear()  # a callback begins: how it came to be called is of no use
        entry = entry.tb_next
    result: TracebackType | None = None
    for entry in reversed(kept):
        result = TracebackType(result, entry.tb_frame, entry.tb_lasti, entry.tb_lineno)
    return result or trace


def _is_ours(entry: TracebackType) -> bool:
    return entry.tb_frame.f_code.co_filename.startswith(_PACKAGE)


def _die_of_sigterm() -> None:
    if _Process.dies_of_sigterm and sys.platform != "win32":
        # The parent shall see what ended us, as it does for a program that ignores SIGTERM's name.
        for stream in (sys.stdout, sys.stderr):
            if stream is not None and not stream.closed:
                stream.flush()
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGTERM)
