"""Default context of the process, which `init()` initialises and nodes use."""

from __future__ import annotations

import threading

from zbot.context.context import Context
from zbot.process import fork

_default: Context | None = None
_default_lock = threading.Lock()


def _renew_lock() -> None:
    global _default_lock  # noqa: PLW0603 - there is one per process
    _default_lock = threading.Lock()


fork.in_child.append(_renew_lock)


def get_default_context(*, shutting_down: bool = False, initialising: bool = False) -> Context:
    """Return the process's default context. If it was shut down, a new context replaces it.

    Args:
        shutting_down: Whether to return the last context even if it was shut down.
        initialising: Whether a new context also replaces a context of the parent process, in a
            forked child.
    """
    global _default  # noqa: PLW0603 - there is one per process
    with _default_lock:
        if (
            _default is None
            or (_default.is_over and not shutting_down)
            or (_default.is_of_parent and initialising)
        ):
            _default = Context()
        return _default
