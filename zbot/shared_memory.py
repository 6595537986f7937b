"""Large messages written straight into the memory that programs of one machine share.

Zenoh moves what is large there by itself, but copies it into a buffer of its own first. Without
that copy a megabyte's way takes a quarter less. Readers on other machines get the same bytes over
the network.
"""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

import zenoh

if TYPE_CHECKING:
    from zenoh.shm import ShmProvider

# As much as Zenoh gives a session for what it moves; kept free by readers that take their messages.
_POOL_BYTES = 16 * 1024 * 1024


def place(payload: bytes) -> Any:
    """Return a payload in shared memory for Zenoh to send, or itself where there is no room.

    For any thread. A block is free again when the last reader has dropped it, or has died.
    """
    pool = _pool()
    if pool is None:
        return payload
    from zenoh.shm import GarbageCollect  # noqa: PLC0415 - see `_pool`

    try:
        block = pool.alloc(len(payload), GarbageCollect())
    except zenoh.ZError:
        return payload  # all of it waits to be read, or the payload is larger
    block[0 : len(payload)] = payload
    return zenoh.ZBytes(block)  # which may be sent again, as a block may not


@functools.cache
def _pool() -> ShmProvider | None:
    """Open this process's pool; `None` where the system or this build of Zenoh has none."""
    from zenoh.shm import ShmProvider  # noqa: PLC0415

    try:
        pool: ShmProvider = ShmProvider.default_backend(_POOL_BYTES)
    except zenoh.ZError:
        return None
    return pool
