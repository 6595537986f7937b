"""Warning at the end of a program that created callbacks, but never ran an executor.

Such a program ends immediately and prints nothing, so a beginner does not see the mistake.
"""

from __future__ import annotations

import os
import sys
from typing import Any

from zbot.errors import library_name
from zbot.names import is_hidden
from zbot.process import at_exit, signals
from zbot.process.call_source import calling_line

# A test often creates nodes that it does not spin.
_TEST_RUNNERS = ("pytest", "unittest")


class Program:
    """What this process has done so far."""

    has_spun = False  #: whether an executor or a wait set waited for work
    first_callback = ""  #: line and function that created the first callback
    pid = 0  #: a child process does not warn about callbacks of its parent


def note_callback(node: str, call: str, callback: Any) -> None:
    """Note that the program gave a node a callback, which needs an executor."""
    if Program.has_spun or Program.first_callback or is_hidden(node) or not _is_program():
        return
    # An action client also subscribes.
    if (getattr(callback, "__module__", None) or "").startswith("zbot.action."):
        return
    line = calling_line()
    if line:
        Program.first_callback = f"{line}: {call}"
        Program.pid = os.getpid()
        at_exit.when_closed.append(_warn)


def _warn(was_interrupted: bool) -> None:
    is_done = Program.has_spun or was_interrupted or Program.pid != os.getpid()
    if is_done or signals.was_received() or _has_failed():
        return
    print(
        f"{Program.first_callback}: the callback never ran, because the program ended without "
        f"spinning: write {library_name()}.spin(node) before its end",
        file=sys.stderr,
    )


def _has_failed() -> bool:
    """Return whether Python has printed a traceback for an exception that ended the program."""
    return hasattr(sys, "last_value")


def _is_program() -> bool:
    """Return whether the process runs a file, and neither tests nor an interactive session."""
    # At the end of the process, Python has already removed `__file__`.
    is_interactive = hasattr(sys, "ps1") or bool(sys.flags.interactive)
    has_file = hasattr(sys.modules.get("__main__"), "__file__")
    return has_file and not is_interactive and not any(map(sys.modules.get, _TEST_RUNNERS))
