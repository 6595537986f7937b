"""How the process treats its memory: the blocks of large messages, and what lives to the end."""

from __future__ import annotations

import functools
import gc
import sys

LARGE_BYTES = 128 * 1024  #: from here on glibc treats a block as large
# Freed blocks up to this are kept for the next message instead of going back to the kernel.
_KEPT_BYTES = 64 * 1024 * 1024
_M_TRIM_THRESHOLD = -1  # malloc.h of glibc
_M_MMAP_THRESHOLD = -3


@functools.cache
def keep_freed_memory() -> None:
    """Let glibc keep freed blocks; once a process, at its first large message.

    By default it gives a block of a megabyte back to the kernel after each message and faults its
    pages in again for the next one: publishing an image took 0.87 ms that way, and takes 0.04 ms.
    Does nothing on other systems.
    """
    if sys.platform == "linux":
        import ctypes  # noqa: PLC0415 - few programs send large messages

        mallopt = getattr(ctypes.CDLL(None), "mallopt", None)  # musl has none
        if mallopt is not None:
            mallopt(_M_TRIM_THRESHOLD, _KEPT_BYTES)
            mallopt(_M_MMAP_THRESHOLD, _KEPT_BYTES)


def spare_the_collector() -> None:
    """Let the garbage collector pass over what there is now.

    For the end of a module that imports much: modules, classes and functions live as long as the
    process. To look through all of them takes 5 ms, tens with numpy and its like, of a callback's
    time every now and then, and at the end twice: a tenth of what a short command takes. What a
    program has made by then is passed over too, which matters only if it is in cycles.
    Does nothing where Python is not CPython.
    """
    if sys.implementation.name == "cpython":
        gc.freeze()
