"""Shared memory: all programs of one machine can read the large messages in it.

Zenoh itself also moves large messages into shared memory, but first copies them into a buffer.
This module avoids that copy, so a message of one megabyte takes a quarter less time. Readers on
other machines get the same bytes over the network.
"""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

import zenoh

if TYPE_CHECKING:
    from zenoh.shm import ShmProvider, ZShmMut

# Zenoh's own pool for a session has the same size. Each message in a pool takes one block.
_POOL_BYTES = 16 * 1024 * 1024


def place(payload: bytes) -> Any:
    """Return a payload in shared memory, or the payload itself if the pool is full.

    Any thread may call this. A block is free again when its last reader has dropped the block or
    has ended.
    """
    pool = _pool()
    if pool is None:
        return payload
    block = _block(pool, len(payload)) or _block(_tidied(pool), len(payload))
    if block is None:
        return payload  # the messages in the pool are not read yet, or the payload is too large
    block[0 : len(payload)] = payload
    return zenoh.ZBytes(block)  # unlike a block, `ZBytes` can be sent several times


def leave_to_parent() -> ShmProvider | None:
    """In a forked child, forget the pool of the parent process, and return it."""
    pool = _pool() if _pool.cache_info().currsize else None
    _pool.cache_clear()
    return pool


def _block(pool: ShmProvider, size: int) -> ZShmMut | None:
    try:
        return pool.alloc(size)
    except zenoh.ZError:
        return None


def _tidied(pool: ShmProvider) -> ShmProvider:
    """Free all blocks that were read, join the free blocks, and return the pool.

    Zenoh's allocation policies free blocks or join blocks, but do not do both in one call. So they
    find no space for a block that is larger than the earlier blocks.
    """
    pool.garbage_collect()
    pool.defragment()
    return pool


@functools.cache
def _pool() -> ShmProvider | None:
    """Return this process's pool, or `None` if the system or Zenoh does not have shared memory."""
    from zenoh.shm import ShmProvider  # noqa: PLC0415

    try:
        pool: ShmProvider = ShmProvider.default_backend(_POOL_BYTES)
    except zenoh.ZError:
        return None
    return pool
