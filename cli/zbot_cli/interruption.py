"""What Ctrl-C does while nobody can handle it: before a command has begun, and after its end."""

from __future__ import annotations

import signal
import sys

TYPE_CHECKING = False  # typing takes 10 ms to load, in which Ctrl-C would print a traceback
if TYPE_CHECKING:
    from types import TracebackType


def end_at_once() -> None:
    """Let Ctrl-C end the process without a word.

    Python would print a traceback of whatever is being imported. Main thread only; a parent that
    had it ignored, as nohup has, is obeyed.
    """
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def raise_exception() -> None:
    """Let Ctrl-C raise `KeyboardInterrupt` again; main thread only.

    Nothing is told of one that nobody catches: it may come just after a command's end.
    """
    if signal.getsignal(signal.SIGINT) is signal.SIG_DFL:
        sys.excepthook = _tell
        signal.signal(signal.SIGINT, signal.default_int_handler)


def _tell(kind: type[BaseException], value: BaseException, trace: TracebackType | None) -> None:
    if not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, value, trace)
