"""Warnings about callbacks that never run, and about a spin that runs in the wrong place.

A program without a spin ends immediately and prints nothing, or it stays in a loop. With two calls
of `spin`, the second one waits for the end of the first one. So a beginner does not see the
mistake.
"""

from __future__ import annotations

import os
import sys
from typing import Any

from zbot.errors import library_name
from zbot.errors.call_source import called_target, calling_line
from zbot.log import get_logger
from zbot.names import is_hidden
from zbot.process import at_exit, signals
from zbot.process.main_part import is_program


class Program:
    """What this process has done so far."""

    has_spun = False  #: whether an executor waited for work
    takes_itself = False  #: whether it takes messages without an executor, e.g. with a wait set
    first_callback = ""  #: line and function that created the first callback
    was_told = False  #: whether a warning has said that the first callback waits
    pid = 0  #: a child process does not warn about callbacks of its parent


def callback_place(node: str, call: str, callback: Any) -> str:
    """Return where the program gives a node a callback, e.g. `talker.py:12: create_timer`.

    The result is empty if nobody has to spin the node, or if the caller is not a program.

    Args:
        node: The base name of the node.
        call: The function that creates the entity.
        callback: The callback.
    """
    if Program.takes_itself or is_hidden(node) or not is_program():
        return ""
    module = getattr(callback, "__module__", None) or ""
    if module.startswith("zbot.action."):  # an action client also subscribes
        return ""
    if module.startswith("zbot.lifecycle."):  # the node itself creates its services
        call = "LifecycleNode"
    line = calling_line()
    return line and f"{line}: {call}"


def note_callback(place: str) -> None:
    """Note the program's first callback, and warn at the end if the program never spins."""
    if not (Program.has_spun or Program.first_callback):
        Program.first_callback = place
        Program.pid = os.getpid()
        at_exit.when_closed.append(_warn)


def waiting_text(place: str, waited_s: float) -> str:
    """Return that a callback waits, because its node was never spun.

    The result is empty if the program needs no executor.

    Args:
        place: The result of `callback_place`.
        waited_s: Seconds since that call.
    """
    if Program.takes_itself:
        return ""
    begin = f"{place}: the callback has waited for {waited_s:g} s, because nothing spins "
    if Program.has_spun:
        return (
            f"{begin}this node, only another one: give both nodes to one executor with add_node(), "
            "and spin that executor"
        )
    Program.was_told = True  # the end of the program need not say it again
    return f"{begin}the node: write {library_name()}.spin(node), and no endless loop before it"


def warn_of_target() -> None:
    """Warn if a program writes `Thread(target=rclpy.spin(node))`, which spins before the thread."""
    if target := called_target():
        get_logger("zbot").warning(
            f"{calling_line()}: the spin runs here, and not in the thread: write {target}"
        )


def _warn(was_interrupted: bool) -> None:
    is_done = Program.has_spun or Program.takes_itself or Program.was_told
    is_child = Program.pid != os.getpid()
    if is_done or is_child or was_interrupted or signals.was_received() or _has_failed():
        return
    print(
        f"{Program.first_callback}: the callback never ran, because the program ended without "
        f"spinning: write {library_name()}.spin(node) before its end",
        file=sys.stderr,
    )


def _has_failed() -> bool:
    """Return whether Python has printed a traceback for an exception that ended the program."""
    return hasattr(sys, "last_value")
