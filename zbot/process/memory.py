"""Memory of the process: glibc's allocator and Python's garbage collector."""

from __future__ import annotations

import functools
import gc
import sys

LARGE_BYTES = 128 * 1024  #: glibc treats a block of this size or more as large
# glibc's largest threshold for large blocks is 32 MiB (DEFAULT_MMAP_THRESHOLD_MAX in malloc.c).
_LARGEST_BYTES = 32 * 1024 * 1024 - 8192


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


def freeze_garbage_collector() -> None:
    """Let the garbage collector ignore all objects that exist now.

    zbot's own processes call this after their imports, because modules, classes and functions exist
    as long as the process. A full collection of these objects takes 5 ms, and with numpy tens of
    ms. Such a collection can happen inside a callback. It also happens twice at the exit, where it
    takes a tenth of a short command's time. If Python is not CPython, the function does nothing.
    """
    if sys.implementation.name == "cpython":
        gc.freeze()
