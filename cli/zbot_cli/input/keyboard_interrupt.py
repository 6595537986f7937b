"""Handlers of Ctrl-C for the time before a command starts and after it ends."""

from __future__ import annotations

import sys

TYPE_CHECKING = False  # importing typing takes 10 ms, during which Ctrl-C prints a traceback
if TYPE_CHECKING:
    import signal
    from types import TracebackType
else:
    import _signal as signal  # the C module: importing `signal` itself takes 5 ms

_RAISE_AGAIN_AFTER_S = 0.005


def end_process_on_ctrl_c() -> None:
    """Let Ctrl-C end the process without output, also during imports.

    Only the main thread may call this function. If SIGINT was ignored when this process started, it
    stays ignored. For example, a shell script ignores SIGINT in a command with `&`. If SIGINT was
    blocked, as in a process that a launch starts, it is unblocked.
    """
    if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def raise_on_ctrl_c() -> None:
    """Undo `end_process_on_ctrl_c`, so that Ctrl-C raises `KeyboardInterrupt`.

    Only the main thread may call this function. It sets two hooks. The first hook prints no
    traceback of `KeyboardInterrupt`, because Ctrl-C may come just after the end of a command. The
    second hook raises the signal again after 5 ms if Python has dropped its exception, e.g. in a
    callback of an import. It does this for SIGTERM too.
    """
    if signal.getsignal(signal.SIGINT) == signal.SIG_DFL:
        sys.excepthook, sys.unraisablehook = _print_unless_interrupt, _raise_again
        signal.signal(signal.SIGINT, signal.default_int_handler)


def signal_behind(error: BaseException) -> BaseException:
    """Return the exception of the signal that is the cause of an error, or the error itself.

    If a signal comes while a module in C++ is imported, pybind11 replaces the exception of the
    signal by an `ImportError`.
    """
    cause: BaseException | None = error
    while isinstance(cause, ImportError):
        cause = cause.__cause__
    return cause if isinstance(cause, (KeyboardInterrupt, SystemExit)) else error


def _print_unless_interrupt(
    kind: type[BaseException], value: BaseException, trace: TracebackType | None
) -> None:
    if issubclass(kind, KeyboardInterrupt):
        return
    if hasattr(sys.stderr, "stream"):  # a TerminalStream, which would show Python's colours as text
        import traceback  # noqa: PLC0415 - only for errors in zbot and for --debug

        traceback.print_exception(kind, value, trace)
    else:
        sys.__excepthook__(kind, value, trace)


def _raise_again(dropped: sys.UnraisableHookArgs) -> None:
    value = dropped.exc_value
    number = signal.SIGINT if isinstance(value, KeyboardInterrupt) else None
    if isinstance(value, SystemExit):
        number = getattr(value, "number", number)  # zbot's handlers raise it (`SignalExit`)
    if number is None:
        sys.__unraisablehook__(dropped)
        return
    import contextlib  # noqa: PLC0415 - seldom used
    import threading  # noqa: PLC0415 - seldom used

    started = False
    while not started:
        again = threading.Timer(_RAISE_AGAIN_AFTER_S, signal.raise_signal, [number])
        again.daemon = True
        # If start() takes longer than the timer, the exception comes here: start a new timer.
        with contextlib.suppress(KeyboardInterrupt, SystemExit):
            again.start()
            started = True
