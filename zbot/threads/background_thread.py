"""Thread that works during a `with` block."""

from __future__ import annotations

import contextlib
import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


@contextlib.contextmanager
def background_thread(name: str, work: Callable[[threading.Event], object]) -> Iterator[None]:
    """Run a function in a daemon thread. The end of the `with` block waits for its end.

    Args:
        name: Name of the thread, for debuggers.
        work: The function. It gets an event, and must return soon after the event is set. The end
            of the `with` block sets the event.
    """
    is_over = threading.Event()
    thread = threading.Thread(target=work, args=(is_over,), name=name, daemon=True)
    thread.start()
    try:
        yield
    finally:
        is_over.set()
        thread.join()
