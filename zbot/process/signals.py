"""Signal handlers and exception hooks, so that a process closes its Zenoh sessions when it ends.

Python cannot end while a session with a subscriber is open. Ctrl-C raises `KeyboardInterrupt` as
usual. SIGTERM raises `ExternalShutdownException` if the main thread spins, else `SystemExit`.
If the program does not catch one of these exceptions, no traceback is printed.
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
from zbot.transport.foreign_call import is_deferring_signals
from zbot.transport.weak_set import WeakSet

if TYPE_CHECKING:
    from types import FrameType

_PACKAGE = str(Path(__file__).parents[1]) + os.sep
_TERMINATED = 128 + signal.SIGTERM
_RETRY_S = 0.005  # longer than a callback of Zenoh, and than the start of a thread


class SignalHandlerOptions(enum.Enum):
    """The signals that `init()` handles."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


class GuardCondition(Protocol):
    """The part of a guard condition that a signal uses."""

    def trigger(self) -> None:
        """Wake the threads that wait for the guard condition. Any thread may call this."""


#: The guard conditions that Ctrl-C and SIGTERM trigger.
guard_conditions: WeakSet[GuardCondition] = WeakSet()


class _Process:
    """State of this process: its handlers before `install()`, and the signal that ends it."""

    previous: dict[int, Any] = {}  # noqa: RUF012 - one per process
    has_hooks = False
    got_sigterm = False
    ends_by_sigterm = False


class MainThread:
    """State of the main thread for the signal handlers."""

    spins = 0  #: number of executors that spin in it (a callback may spin another executor)


def install(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Install the exception hooks and, in the main thread, the signal handlers.

    Python allows signal handlers in the main thread only.
    """
    _install_hooks()
    if threading.current_thread() is not threading.main_thread():
        return
    if options in {SignalHandlerOptions.SIGINT, SignalHandlerOptions.ALL}:
        _replace(signal.SIGINT, _on_sigint)
    if options in {SignalHandlerOptions.SIGTERM, SignalHandlerOptions.ALL}:
        _replace(signal.SIGTERM, _on_sigterm)


def uninstall() -> None:
    """Restore the signal handlers that were installed before `install()`."""
    if threading.current_thread() is threading.main_thread():
        for number, handler in _Process.previous.items():
            signal.signal(number, handler)
        _Process.previous.clear()


def installed() -> SignalHandlerOptions:
    """Return the signals that are handled now."""
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
        # A new thread triggers them, because the interrupted thread may hold a condition's lock.
        threading.Thread(target=_trigger_guards, daemon=True).start()


def _trigger_guards() -> None:
    for guard in guard_conditions:
        guard.trigger()


def _is_postponed(number: int, frame: FrameType | None) -> bool:
    """Return whether a signal must wait for the interrupted code. If so, send it again soon."""
    if not is_deferring_signals(frame):
        return False
    retry = threading.Timer(_RETRY_S, _signal_main_thread, [number])
    retry.daemon = True
    retry.start()
    return True


def _signal_main_thread(number: int) -> None:
    """Send the main thread a signal that also interrupts a sleep."""
    if sys.platform == "win32":
        signal.raise_signal(number)
    else:
        signal.pthread_kill(threading.main_thread().ident or 0, number)


def _on_sigint(number: int, frame: FrameType | None) -> None:
    if at_exit.is_ending() or _is_postponed(number, frame):
        return
    _interrupt_contexts()
    previous = _Process.previous.get(number)
    if callable(previous) and previous is not signal.default_int_handler:
        previous(number, frame)
        return
    raise KeyboardInterrupt


def _on_sigterm(number: int, frame: FrameType | None) -> None:
    if at_exit.is_ending() or _is_postponed(number, frame):
        return
    _interrupt_contexts()
    previous = _Process.previous.get(number)
    if callable(previous):
        previous(number, frame)
        return
    _Process.got_sigterm = True
    if MainThread.spins:
        raise ExternalShutdownException
    _Process.ends_by_sigterm = True
    raise SystemExit(_TERMINATED)


def _install_hooks() -> None:
    if _Process.has_hooks:
        return
    _Process.has_hooks = True
    sys.excepthook = _excepthook_before(sys.excepthook)
    thread_hook = threading.excepthook

    def on_thread_exception(args: threading.ExceptHookArgs) -> None:
        ignored: tuple[type[BaseException], ...] = (ExternalShutdownException, KeyboardInterrupt)
        if at_exit.is_ending():
            ignored += (NotInitializedError,)  # the thread used a context that was closed
        if not issubclass(args.exc_type, ignored):
            _remove_zbot_frames(args.exc_value)
            thread_hook(args)

    threading.excepthook = on_thread_exception
    sys.unraisablehook = _unraisablehook_before(sys.unraisablehook)
    at_exit.register()
    atexit.register(_end_by_sigterm)


def _excepthook_before(previous: Any) -> Any:
    """Return a hook that prints no traceback of signals and setup errors.

    The hook gives other exceptions to `previous`.
    """

    def excepthook(
        kind: type[BaseException], value: BaseException, trace: TracebackType | None
    ) -> None:
        if issubclass(kind, SetupError):
            print(value, file=sys.stderr)
        elif issubclass(kind, ExternalShutdownException):
            _Process.ends_by_sigterm = _Process.got_sigterm  # the program did not catch it
        elif not issubclass(kind, KeyboardInterrupt):
            _remove_zbot_frames(value)
            previous(kind, value, value.__traceback__ or trace)

    return excepthook


def _unraisablehook_before(previous: Any) -> Any:
    """Return a hook that sends a signal again if its exception was lost in a destructor."""

    def unraisablehook(args: Any) -> None:
        number = signal.SIGINT if args.exc_type is KeyboardInterrupt else signal.SIGTERM
        ours = (KeyboardInterrupt, ExternalShutdownException, SystemExit)
        if at_exit.is_ending() or sys.platform == "win32" or not issubclass(args.exc_type, ours):
            previous(args)
        else:
            # A RuntimeError means that the process is ending already, as the signal asked.
            with contextlib.suppress(RuntimeError):
                threading.Timer(_RETRY_S, _signal_main_thread, [number]).start()

    return unraisablehook


def _remove_zbot_frames(value: BaseException | None) -> None:
    # Python prints the exception's own traceback, not the traceback that a hook passes on.
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
    return entry.tb_frame.f_code.co_filename.startswith(_PACKAGE)


def _end_by_sigterm() -> None:
    if _Process.ends_by_sigterm and sys.platform != "win32":
        # The parent then sees that SIGTERM ended this process, as for a program without a handler.
        for stream in (sys.stdout, sys.stderr):
            if stream is not None and not stream.closed:
                stream.flush()
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGTERM)
