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
    from zenoh.shm import ShmProvider, ZShmMut

# As much as Zenoh gives a session for what it moves; kept free by readers that take their messages.
_POOL_BYTES = 16 * 1024 * 1024


def place(payload: bytes) -> Any:
    """Return a payload in shared memory for Zenoh to send, or itself where there is no room.

    For any thread. A block is free again when the last reader has dropped it, or has died.
    """
    pool = _pool()
    if pool is None:
        return payload
    block = _block(pool, len(payload)) or _block(_tidied(pool), len(payload))
    if block is None:
        return payload  # all of the pool waits to be read, or the payload is larger
    block[0 : len(payload)] = payload
    return zenoh.ZBytes(block)  # which may be sent again, as a block may not


def _block(pool: ShmProvider, size: int) -> ZShmMut | None:
    try:
        return pool.alloc(size)
    except zenoh.ZError:
        return None


def _tidied(pool: ShmProvider) -> ShmProvider:
    """Return the pool with all that was read free again, and in one piece.

    Zenoh's own policies of allocation do the one without the other, and find no room for a block
    that is larger than the former ones.
    """
    pool.garbage_collect()
    pool.defragment()
    return pool


@functools.cache
def _pool() -> ShmProvider | None:
    """Open this process's pool; `None` where the system or this build of Zenoh has none."""
    from zenoh.shm import ShmProvider  # noqa: PLC0415

    try:
        pool: ShmProvider = ShmProvider.default_backend(_POOL_BYTES)
    except zenoh.ZError:
        return None
    return pool
