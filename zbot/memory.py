"""Memory of the process: glibc's allocator and Python's garbage collector."""

from __future__ import annotations

import functools
import gc
import sys
from typing import Any

LARGE_BYTES = 128 * 1024  #: glibc treats a block of this size or more as large
# glibc's largest threshold for large blocks is 32 MiB (DEFAULT_MMAP_THRESHOLD_MAX in malloc.c).
_LARGEST_BYTES = 32 * 1024 * 1024 - 8192
# Numbers of malloc.h
_MMAP_THRESHOLD, _ARENA_MAX = -3, -8
_RETURNED_BYTES = 512 * 1024


@functools.cache
def keep_freed_memory() -> None:
    """Let glibc keep freed blocks. Only the first call in a process has an effect.

    When a block is freed, glibc raises its threshold for large blocks to the size of this block.
    After that, glibc keeps at most twice this size of freed memory for the next blocks. So this
    function allocates and frees one block. No code writes to the block. Without this function,
    glibc gives a message's block of a megabyte back to the kernel each time, and the next message
    gets new pages from the kernel. A round trip then takes 6.2 ms instead of 2.9 ms. The call takes
    10 us. Without glibc, it has no effect.
    """
    bytes(_LARGEST_BYTES)


def keep_little_freed_memory() -> None:
    """Let glibc give freed blocks of 512 KiB or more back to the kernel, also for later messages.

    Threads of Python share two of glibc's arenas, because each arena keeps freed memory. In a
    server for Foxglove whose client does not read messages of 1 MB, this saves 17 MB of 125 MB. A
    teacher's hub keeps 15 MB more after some of its openings without this function: these are the
    freed blocks in which Zenoh has read the access rules, in an arena that `malloc_trim` does not
    shorten.

    The opposite is `keep_freed_memory`, which then has no effect. Without glibc, nothing happens.
    """
    if (libc := _glibc()) is not None:
        libc.mallopt(_MMAP_THRESHOLD, _RETURNED_BYTES)
        libc.mallopt(_ARENA_MAX, 2)


def give_back_freed_memory() -> None:
    """Give freed memory back to the kernel, e.g. after the end of a client. It takes milliseconds.

    Other threads of Python run meanwhile. Without glibc, nothing happens.
    """
    if (libc := _glibc()) is not None:
        libc.malloc_trim(0)


def _glibc() -> Any:
    """Return the C library if it is glibc."""
    import ctypes  # noqa: PLC0415 - most programs do not need it

    if sys.platform != "linux":
        return None
    libc = ctypes.CDLL(None)
    return libc if hasattr(libc, "malloc_trim") and hasattr(libc, "mallopt") else None


def freeze_garbage_collector() -> None:
    """Let the garbage collector ignore all objects that exist now.

    zbot's own processes call this after their imports, because modules, classes and functions exist
    as long as the process. A full collection of these objects takes 5 ms, and with numpy tens of
    ms. Such a collection can happen inside a callback. It also happens twice at the exit, where it
    takes a tenth of a short command's time. If Python is not CPython, the function does nothing.
    """
    if sys.implementation.name == "cpython":
        gc.freeze()
