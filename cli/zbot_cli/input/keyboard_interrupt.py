"""What Ctrl-C does while nobody can handle it: before a command has begun, and after its end."""

from __future__ import annotations

import sys

TYPE_CHECKING = False  # to import typing takes 10 ms, in which Ctrl-C would print a traceback
if TYPE_CHECKING:
    import signal
    from types import TracebackType
else:
    import _signal as signal  # its heart: the module itself imports for 5 ms

_MOMENT_S = 0.005


def end_at_once() -> None:
    """Let Ctrl-C end the process without a word.

    Python would print a traceback of whatever is being imported. Main thread only; a parent that
    had it ignored, as nohup has, is obeyed.
    """
    if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def raise_exception() -> None:
    """Let Ctrl-C raise `KeyboardInterrupt` again; main thread only.

    Nothing is told of one that nobody catches: it may come just after a command's end. One that
    comes where Python drops exceptions, as in what ends an import, is raised again in a moment.
    """
    if signal.getsignal(signal.SIGINT) == signal.SIG_DFL:
        sys.excepthook, sys.unraisablehook = _tell, _repeat
        signal.signal(signal.SIGINT, signal.default_int_handler)


def _tell(kind: type[BaseException], value: BaseException, trace: TracebackType | None) -> None:
    if not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, value, trace)


def _repeat(dropped: sys.UnraisableHookArgs) -> None:
    if not issubclass(dropped.exc_type, KeyboardInterrupt):
        sys.__unraisablehook__(dropped)
        return
    import threading  # noqa: PLC0415 - most commands do without

    again = threading.Timer(_MOMENT_S, signal.raise_signal, [signal.SIGINT])
    again.daemon = True
    again.start()
