"""What Ctrl-C does while nobody can handle it: before a command has begun, and after its end."""

from __future__ import annotations

import signal


def end_at_once() -> None:
    """Let Ctrl-C end the process without a word.

    Python would print a traceback of whatever is being imported. Main thread only; a parent that
    had it ignored, as nohup has, is obeyed.
    """
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def raise_exception() -> None:
    """Let Ctrl-C raise `KeyboardInterrupt` again; main thread only."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_DFL:
        signal.signal(signal.SIGINT, signal.default_int_handler)
