"""Processes that run the inputs of one reader, with limits for time and memory."""

from __future__ import annotations

import itertools
import math
import multiprocessing
import os
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tests.conftest import allowed
from tests.torture.fuzzer import Failure, failures
from tests.torture.reader import readers

if TYPE_CHECKING:
    from tests.torture.reader import Reader

_MEMORY_BYTES = 2 * 2**30  # above what the process has at its start
_HANG_S = 30.0
_MOST_FAILURES = 20
_POLL_S = 0.05


def _limit_memory() -> None:
    if sys.platform == "linux":
        import resource  # noqa: PLC0415 - Windows lacks it

        with Path("/proc/self/statm").open(encoding="ascii") as file:
            pages = int(file.read().split()[0])
        limit = pages * os.sysconf("SC_PAGE_SIZE") + _MEMORY_BYTES
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))


class Run(NamedTuple):
    """What the inputs of one reader gave."""

    failures: list[Failure]
    inputs: int  #: how many were read until the time was over


def _work(
    name: str, seed: str, first: int, count: int, deadline: float, place: Any, found: Any
) -> None:
    reader = next(each for each in readers() if each.name == name)
    _limit_memory()

    def note(number: int) -> None:
        place.value = number

    numbers = itertools.takewhile(lambda _: time.time() < deadline, range(first, count))
    for failure in itertools.islice(failures(reader, seed, numbers, note), _MOST_FAILURES):
        found.put((failure.number, failure.problem))
    place.value = max(first, count if time.time() < deadline else place.value)


def run(reader: Reader, seed: str, count: int, limit_s: float = math.inf) -> Run:
    """Run all inputs of one reader, or those that it reads within a time."""
    deadline = time.time() + limit_s
    context = multiprocessing.get_context("spawn")
    found: list[Failure] = []
    first = 0
    while first < count and len(found) < _MOST_FAILURES and time.time() < deadline:
        place, queue = context.Value("q", first), context.Queue()
        worker = context.Process(
            target=_work,
            args=(reader.name, seed, first, count, deadline, place, queue),
            daemon=True,
        )
        worker.start()
        problem = _watch(worker, place)
        while not queue.empty():
            number, text = queue.get()
            found.append(Failure(reader.name, seed, number, text))
        first = place.value + 1
        if problem:
            found.append(Failure(reader.name, seed, place.value, problem))
    return Run(found, min(first, count))


def _watch(worker: Any, place: Any) -> str:
    """Wait for the end of a worker. Return the problem if it crashed or hangs."""
    last, since = place.value, time.monotonic()
    while worker.is_alive():
        worker.join(_POLL_S)
        if place.value != last:
            last, since = place.value, time.monotonic()
        elif time.monotonic() - since > allowed(_HANG_S):
            worker.kill()
            worker.join()
            return f"no end after {time.monotonic() - since:.0f} s"
    return f"the process ended with {worker.exitcode}" if worker.exitcode else ""
