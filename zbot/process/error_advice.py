"""Advice for the errors that end a program, or a thread, of a program that Python itself started.

In `zbot run`, `zbot.process.hooks` gives this advice.
"""

from __future__ import annotations

import sys
import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from types import TracebackType


def install() -> None:
    """Let an error that Python prints say what to write.

    A program, a debugger or a shell that has exception hooks of its own keeps these hooks.
    """
    if sys.excepthook is sys.__excepthook__:
        sys.excepthook = _print_with_advice
    if threading.excepthook is threading.__excepthook__:
        threading.excepthook = _print_of_thread


def _print_with_advice(
    kind: type[BaseException], value: BaseException, trace: TracebackType | None
) -> None:
    _advise(value)
    sys.__excepthook__(kind, value, trace)


def _print_of_thread(error: threading.ExceptHookArgs) -> None:
    _advise(error.exc_value)
    threading.__excepthook__(error)


def _advise(value: BaseException | None) -> None:
    from zbot.process.hooks import advise  # noqa: PLC0415 - few programs end with an error

    if value is not None:
        advise(value)
