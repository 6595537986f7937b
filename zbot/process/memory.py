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

    When a block is freed, glibc raises its threshold for large blocks to the size of this block,
    and keeps up to twice this size for the next blocks. So one block is freed here that no code
    writes to. Without this, glibc gives a message's block of a megabyte back to the kernel each
    time, and the next message gets new pages from the kernel. A round trip then takes 6.2 ms
    instead of 2.9 ms. The call takes 10 us, and does nothing without glibc.
    """
    bytes(_LARGEST_BYTES)


def freeze_garbage_collector() -> None:
    """Let the garbage collector ignore all objects that exist now.

    A process of our own calls this after its imports, because modules, classes and functions exist
    as long as the process. A full collection of these objects takes 5 ms, with numpy tens of ms. It
    happens inside callbacks, and twice at the exit, where it is a tenth of a short command's time.
    If Python is not CPython, the function does nothing.
    """
    if sys.implementation.name == "cpython":
        gc.freeze()
