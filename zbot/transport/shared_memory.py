"""Shared memory: all programs of one machine can read the large messages in it.

Zenoh itself could also move messages into shared memory, but it first copies them into a buffer.
This module avoids that copy, so a message of one megabyte takes a quarter less time. Readers on
other machines get the same bytes over the network.

A program of Zenoh removes files in `/dev/shm` that no process has locked, when it starts and when
it ends. The file of a new pool is unlocked for a moment. If another program removes it then, no
reader can open it, and all messages in the pool are lost. So a new pool is checked.
"""

from __future__ import annotations

import functools
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zenoh

if TYPE_CHECKING:
    from zenoh.shm import ShmProvider, ZShmMut

_POOL_BYTES = 16 * 1024 * 1024  # each message takes one block of the pool
# With two programs that did nothing but remove files, 40 of 600 new pools lost their files.
_TRIES = 4


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
    """Return this process's pool, or `None` if other programs cannot read it."""
    before = _removed_files()
    for _ in range(_TRIES):
        pool = _new_pool()
        if pool is None or _removed_files() <= before:
            return pool
    return None


def _new_pool() -> ShmProvider | None:
    """Return a new pool with all its files, or `None` if the system has no shared memory."""
    from zenoh.shm import ShmProvider  # noqa: PLC0415

    try:
        pool: ShmProvider = ShmProvider.default_backend(_POOL_BYTES)
        pool.alloc(1)  # the first block of a process makes a file that tells about all blocks
    except zenoh.ZError:
        return None
    return pool


def _removed_files() -> set[str]:
    """Return the files of Zenoh that this process has in its memory, but that are removed."""
    if sys.platform != "linux":  # on other systems, Zenoh removes no files of others
        return set()
    with Path("/proc/self/maps").open(encoding="utf-8", errors="replace") as areas:
        return {area for area in areas if area.endswith(".zenoh (deleted)\n")}
