"""Forked child processes, which leave the contexts of the parent process to the parent.

Only the thread that forks exists in the child. Zenoh's threads do not exist there, and threads that
do not exist may hold Zenoh's locks. So the child must not use, close or free an object of Zenoh
that the parent has made. It leaves these objects as they are, and can open contexts of its own.
"""

from __future__ import annotations

import atexit
import os
import sys
from typing import TYPE_CHECKING, Any

from zbot.log import call_site
from zbot.log.registry import REGISTRY
from zbot.memory import freeze_garbage_collector
from zbot.process import at_exit, blocked_put, signals
from zbot.transport import shared_memory

if TYPE_CHECKING:
    from collections.abc import Callable

#: Functions of higher rooms that a forked child calls, so that they forget their parent's threads
#: and locks. They must be fast, because a child may be about to start another program.
in_child: list[Callable[[], None]] = []

_kept: list[Any] = []


class _Process:
    is_registered = False


def register() -> None:
    """Let a forked child leave all open contexts to this process. A second call does nothing."""
    if not _Process.is_registered and sys.platform != "win32":  # Windows has no fork
        _Process.is_registered = True
        os.register_at_fork(after_in_child=_leave_to_parent)


def keep(*objects: object) -> None:
    """Keep objects of the parent until this process has ended, and never free them.

    Python frees all objects of its modules at its end. It does not free this module's list, because
    the list contains itself, and the garbage collector is told to ignore it.
    """
    if not _kept:
        _kept.append(_kept)
        atexit.register(freeze_garbage_collector)
    _kept.extend(objects)


def _leave_to_parent() -> None:
    # Threads of the parent may hold these locks.
    REGISTRY.renew_locks()
    call_site.renew_lock()
    # Commands such as `zbot topic list` do not load it.
    interfaces = sys.modules.get("zbot.interfaces.registry")
    if interfaces is not None:
        interfaces.renew_lock()
    blocked_put.leave_to_parent()
    contexts = at_exit.leave_to_parent()
    if contexts:
        signals.leave_to_parent()
    for context in contexts:
        context.leave_to_parent()
    keep(contexts, shared_memory.leave_to_parent())
    for forget in in_child:
        forget()
