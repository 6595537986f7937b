"""Short turns of threads, for servers whose threads do long work for some of their clients."""

from __future__ import annotations

import contextlib
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

_TURN_S = 0.0005


@contextlib.contextmanager
def short_turns() -> Iterator[None]:
    """Let Python's threads take turns of 0.5 ms, and not of 5 ms.

    A message passes several threads of a server. While another thread reads a large message, each
    of them waits for a whole turn. This is a setting of the process, so only a process that does
    nothing but serve may use it.
    """
    before_s = sys.getswitchinterval()
    sys.setswitchinterval(_TURN_S)
    try:
        yield
    finally:
        sys.setswitchinterval(before_s)
