"""Signal handlers of `init()`, so that a process closes its Zenoh sessions when it ends.

Python cannot end while a session with a subscriber is open. Ctrl-C raises `KeyboardInterrupt` as
usual. SIGTERM raises `ExternalShutdownException` if the main thread spins. Otherwise SIGTERM makes
`ok()` false, so that a loop `while ok():` ends and the program does the rest of its work. If the
main thread does not call `ok()` within 3 s, SIGTERM raises `SystemExit`. A second SIGTERM raises it
immediately.

The handlers raise subclasses of these exceptions that also inherit from `SystemExit`. So Python
prints no traceback if the program does not catch them, and the process needs no exception hook.
From Python 3.14 on, a `KeyboardInterrupt` is not taken as a `SystemExit`, so Ctrl-C sets a hook.
"""

from __future__ import annotations

import atexit
import contextlib
import enum
import os
import signal
import sys
import threading
from typing import TYPE_CHECKING, Any, NoReturn, Protocol

from zbot.errors import ExternalShutdownException, NotInitializedError
from zbot.process import at_exit
from zbot.threads.foreign_call import is_deferring_signals
from zbot.threads.weak_set import WeakSet

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import FrameType, TracebackType

#: A signal that cannot raise its exception now is sent again after this time. A callback of Zenoh
#: takes less time, and so does the start of a thread.
RETRY_S = 0.005
_NEEDS_HOOK = sys.version_info >= (3, 14)
# A loop usually calls `ok()` at least once a second. The time is shorter than the 5 s after which
# `launch` kills a program that SIGTERM does not end.
_LOOK_TIMEOUT_S = 3.0
# After a signal, the main thread usually ends within 0.1 s, even on a busy machine.
_END_TIMEOUT_S = 0.3


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


class SignalledContext(Protocol):
    """The part of a context that a signal uses."""

    def interrupt(self) -> None:
        """Make `ok()` false, and let all executors stop spinning."""


#: Every context that is initialised.
contexts: WeakSet[SignalledContext] = WeakSet()
#: The guard conditions that Ctrl-C and SIGTERM trigger.
guard_conditions: WeakSet[GuardCondition] = WeakSet()


class _Process:
    """State of this process: the handlers before `install()`, and the signal that ends it."""

    previous: dict[int, Any] = {}  # noqa: RUF012 - one per process
    received: int = signal.SIGINT  #: the last signal
    count = 0  #: number of signals so far
    installed_by = 0  #: id of the process that called `install()`
    is_terminated = False  #: whether SIGTERM has come since `install()`
    must_look = False  #: whether SIGTERM has come, and `ok()` was not called since then
    has_waited = False  #: whether the main thread has waited in vain since then
    calls_ok = True  #: whether the main thread may call `ok()`
    ends_by: int | None = None
    ends_visibly = False  #: whether `_end_by_signal` is registered


class SignalExit(SystemExit):
    """The exception of a signal. If no code catches it, the signal ends the process.

    Args:
        number: The signal.
    """

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number
        _Process.must_look = False  # the main thread gets this exception

    @property
    def code(self) -> int:  # type: ignore[override]
        """The exit code. If no code has caught the exception, Python reads this at the exit."""
        _Process.ends_by = self.number
        return 128 + self.number


class Interrupted(SignalExit, KeyboardInterrupt):
    """`KeyboardInterrupt` for which Python prints no traceback."""


class _QuietHook:
    """Exception hook that prints no traceback of `Interrupted`.

    Args:
        previous: The hook for all other exceptions.
    """

    def __init__(self, previous: Callable[..., object]) -> None:
        self._previous = previous

    def __call__(
        self, kind: type[BaseException], value: BaseException, trace: TracebackType | None
    ) -> None:
        """Handle an exception that no code has caught."""
        if isinstance(value, Interrupted):
            _Process.ends_by = value.number
        else:
            self._previous(kind, value, trace)


class ShutdownBySignal(SignalExit, ExternalShutdownException):
    """`ExternalShutdownException` for which Python prints no traceback."""


class MainThread:
    """State of the main thread for the signal handlers."""

    #: The executors that it spins. A callback may spin another executor.
    spinning: set[object] = set()  # noqa: RUF012 - one per process


def install(
    options: SignalHandlerOptions = SignalHandlerOptions.ALL, *, calls_ok: bool = True
) -> None:
    """Install the signal handlers. Python allows this in the main thread only.

    Args:
        options: The signals to handle.
        calls_ok: Whether the main thread may call `ok()`. Otherwise, e.g. in a server with an event
            loop, SIGTERM raises `SystemExit` immediately.
    """
    at_exit.register()
    _Process.installed_by, _Process.is_terminated = os.getpid(), False
    _Process.calls_ok = calls_ok
    if threading.current_thread() is not threading.main_thread():
        return
    if not _Process.ends_visibly:
        _Process.ends_visibly = True
        atexit.register(_end_by_signal)
        at_exit.when_closed.append(_let_signals_end)
    if options in {SignalHandlerOptions.SIGINT, SignalHandlerOptions.ALL}:
        _replace(signal.SIGINT, _on_sigint)
    if options in {SignalHandlerOptions.SIGTERM, SignalHandlerOptions.ALL}:
        _replace(signal.SIGTERM, _on_sigterm)


@contextlib.contextmanager
def ending_process() -> Iterator[None]:
    """Let SIGINT and SIGTERM end the process immediately in a `with` block of imports.

    Some libraries in C++, e.g. MuJoCo, drop the exceptions of signals while they are imported, and
    the program would go on. Ignored signals stay ignored. In other threads, this does nothing.
    """
    previous = {}
    if threading.current_thread() is threading.main_thread():
        for number in (signal.SIGINT, signal.SIGTERM):
            if signal.getsignal(number) not in {None, signal.SIG_IGN}:
                previous[number] = signal.signal(number, signal.SIG_DFL)
    try:
        yield
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)


def add_context(context: SignalledContext) -> None:
    """Let signals interrupt a context from now on.

    If SIGTERM has come since `install()`, and nobody has noticed it, e.g. while `init()` read the
    arguments, the context is interrupted now.
    """
    contexts.add(context)
    if _Process.must_look:
        context.interrupt()


def was_received() -> bool:
    """Return whether the process got a signal that `install()` handles."""
    return _Process.count > 0


def uninstall() -> None:
    """Restore the signal handlers that were installed before `install()`."""
    if threading.current_thread() is threading.main_thread():
        for number, handler in _Process.previous.items():
            signal.signal(number, handler)
        _Process.previous.clear()
        _Process.must_look = False


def leave_to_parent() -> None:
    """In a forked child, restore the handlers that the parent had before `install()`.

    So a signal ends the child as if the parent had no node. rclpy's handlers do not work in a child
    either: SIGTERM does nothing there.
    """
    for number, handler in _Process.previous.items():
        if ends_program(number):
            signal.signal(number, handler)
    _Process.previous.clear()
    _Process.received, _Process.count, _Process.ends_by = signal.SIGINT, 0, None
    MainThread.spinning.clear()
    guard_conditions.clear()


def installed() -> SignalHandlerOptions:
    """Return the signals that are handled now."""
    own = (signal.SIGINT in _Process.previous) + 2 * (signal.SIGTERM in _Process.previous)
    return SignalHandlerOptions(own)


def ends_program(number: int) -> bool:
    """Return whether a signal's handler is one of `install()`. Such a signal ends spinning."""
    return signal.getsignal(number) in {_on_sigint, _on_sigterm}


def _replace(number: int, handler: Any) -> None:
    present = signal.getsignal(number)
    if present is not handler:
        _Process.previous[number] = present if present is not None else signal.SIG_DFL
        signal.signal(number, handler)


def _interrupt_contexts(number: int) -> None:
    _Process.received = number
    _Process.count += 1
    for context in contexts:
        context.interrupt()
    if guard_conditions:
        # A new thread triggers the guard conditions, because the interrupted thread may hold the
        # lock of a guard condition.
        _start(threading.Thread(target=_trigger_guards))


def _trigger_guards() -> None:
    for guard in guard_conditions:
        guard.trigger()


def _is_postponed(number: int, frame: FrameType | None) -> bool:
    """Return whether a signal must wait for the interrupted code. If so, send it again later."""
    if not is_deferring_signals(frame):
        return False
    send_again(number)
    return True


def send_again(number: int) -> None:
    """Send the main thread a signal again after 5 ms."""
    if not _start(threading.Timer(RETRY_S, _signal_main_thread, [number])):
        _Process.ends_by = number


def _start(thread: threading.Thread) -> bool:
    """Start a daemon thread. Return `False` if Python already ends and starts no threads."""
    thread.daemon = True
    try:
        thread.start()
    except RuntimeError:
        return False
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
    _interrupt_contexts(number)
    previous = _Process.previous.get(number)
    if callable(previous) and previous is not signal.default_int_handler:
        previous(number, frame)
        return
    # At a prompt, or in a notebook, Ctrl-C ends only the present statement.
    is_interactive = hasattr(sys, "ps1") or sys.flags.interactive
    if is_interactive:
        raise KeyboardInterrupt
    if _NEEDS_HOOK and not isinstance(sys.excepthook, _QuietHook):
        sys.excepthook = _QuietHook(sys.excepthook)
    raise Interrupted(number)


def _on_sigterm(number: int, frame: FrameType | None) -> None:
    if at_exit.is_ending() or _is_postponed(number, frame):
        return
    is_second, _Process.is_terminated = _Process.is_terminated, True
    previous = _Process.previous.get(number)
    is_at_once = callable(previous) or bool(MainThread.spinning) or is_second
    # Threads that spin wake up now. They wait as long as the main thread has time to call `ok()`.
    _Process.must_look, _Process.has_waited = not is_at_once and _may_look(), False
    _interrupt_contexts(number)
    if callable(previous):
        previous(number, frame)
        return
    if MainThread.spinning:
        raise ShutdownBySignal(number)
    timer = threading.Timer(_LOOK_TIMEOUT_S, _end_unlooked)
    if not (_Process.must_look and _start(timer)):
        _Process.must_look = False
        raise SignalExit(number)


def _may_look() -> bool:
    """Return whether the program may still call `ok()`. A forked child may do other work."""
    uses_zbot = bool(at_exit.open_contexts) or os.getpid() == _Process.installed_by
    return _Process.calls_ok and uses_zbot and not at_exit.wait_for_end(0)


def _end_unlooked() -> None:
    if _Process.must_look:
        _signal_main_thread(signal.SIGTERM)


def note_look() -> None:
    """Note that the program has called `ok()` and got `False`.

    If the main thread has called it, the program has noticed SIGTERM, and ends on its own.
    """
    if threading.current_thread() is threading.main_thread():
        _Process.must_look = False


def last_signal() -> int:
    """Return the last signal that `install()`'s handlers got, or SIGINT if there was none."""
    return _Process.received


def raise_shutdown(*, by_signal: bool) -> NoReturn:
    """Raise `ExternalShutdownException`.

    After a signal, a daemon thread first waits for the end of the main thread: at most 0.3 s, or
    0.3 s more than SIGTERM gives the main thread. If the main thread ends in this time, the daemon
    thread ends without output. Otherwise the exception is raised. At the end of the process, all
    threads end without output.

    Args:
        by_signal: Whether a signal has interrupted the context.
    """
    thread = threading.current_thread()
    if by_signal and thread is threading.main_thread():
        raise ShutdownBySignal(_Process.received)
    # Python would print the traceback of an exception that is not a `SystemExit`.
    if thread is not threading.main_thread() and (
        at_exit.is_ending() or (by_signal and thread.daemon and _main_thread_ends())
    ):
        raise SystemExit
    raise ExternalShutdownException


def _main_thread_ends() -> bool:
    while _Process.must_look:
        if at_exit.wait_for_end(_END_TIMEOUT_S):
            return True
    return at_exit.wait_for_end(_END_TIMEOUT_S)


def note_vain_wait() -> None:
    """Note a wait that ends at once, because its context does not run any more.

    Otherwise, after SIGTERM, a loop such as `while not client.wait_for_service(1.0):` would run for
    3 s without a pause.

    Raises:
        ExternalShutdownException: This is the second such wait of the main thread since SIGTERM,
            and it has not called `ok()` in between.
    """
    if _Process.must_look and threading.current_thread() is threading.main_thread():
        if _Process.has_waited:
            raise ShutdownBySignal(_Process.received)
        _Process.has_waited = True


def raise_not_initialized(what: str) -> NoReturn:
    """Raise `NotInitializedError`. When the process ends, end the calling thread without output."""
    is_main = threading.current_thread() is threading.main_thread()
    if at_exit.is_ending() and not is_main:
        raise SystemExit
    if _Process.must_look and is_main:
        raise ShutdownBySignal(_Process.received)  # the context is interrupted by SIGTERM
    raise NotInitializedError(what) from None


def _let_signals_end(was_interrupted: bool) -> None:
    """From now on, let a signal end the process immediately.

    Otherwise a thread of the program could run for ever.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        if ends_program(number):
            signal.signal(number, signal.SIG_DFL)
    if was_interrupted and _Process.count > 1:  # the first signal ended the main thread
        _Process.ends_by = _Process.received
        _end_by_signal()


def _end_by_signal() -> None:
    if _Process.ends_by is not None and sys.platform != "win32":
        # The parent then sees that the signal ended this process, as without a handler.
        for stream in (sys.stdout, sys.stderr):
            if stream is not None and not stream.closed:
                stream.flush()
        signal.signal(_Process.ends_by, signal.SIG_DFL)
        os.kill(os.getpid(), _Process.ends_by)
