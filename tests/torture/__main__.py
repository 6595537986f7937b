"""Run the torture test: `python -m tests.torture -n 1000000`.

Each reader runs in a process of its own with a limit for its memory. If a process crashes or hangs,
the number of the input is known, and the reader continues with the next input.
"""

from __future__ import annotations

import argparse
import math
import secrets
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import TYPE_CHECKING

from tests.torture.fuzzer import input_of
from tests.torture.readers import READERS
from tests.torture.worker import run

if TYPE_CHECKING:
    from tests.torture.reader import Reader


def _again(reader: Reader, seed: str, number: int) -> None:
    data = input_of(reader, seed, number)
    print(f"{reader.name}: {len(data)} bytes: {data[:500]!r}")
    begin = time.process_time()
    try:
        print("accepted:", reader.call(data))
    except reader.errors as error:
        print(f"refused: {type(error).__name__}: {error!s:.500}")
    print(f"{time.process_time() - begin:.3f} s")


def _run(reader: Reader, *, seed: str, inputs: int, limit_s: float) -> int:
    started = time.monotonic()
    found, done = run(reader, seed, inputs, limit_s)
    took_s = time.monotonic() - started
    lines = [f"{reader.name}: {done} inputs in {took_s:.0f} s, {len(found)} failures"]
    print("\n  ".join(lines + [str(failure) for failure in found]), flush=True)
    return len(found)


def main() -> int:
    parser = argparse.ArgumentParser(description="Torture the readers of foreign bytes and text.")
    parser.add_argument("-n", "--inputs", type=int, default=1_000_000, help="inputs of each reader")
    parser.add_argument("--seed", default="", help="text; the same seed makes the same inputs")
    parser.add_argument("--reader", action="append", help="only this reader (can be repeated)")
    parser.add_argument("--jobs", type=int, default=1, help="readers that run at the same time")
    parser.add_argument("--minutes", type=float, default=math.inf, help="limit for each reader")
    parser.add_argument("--input", type=int, help="run only the input with this number")
    given = parser.parse_args()
    seed = given.seed or secrets.token_hex(4)
    readers = [reader for reader in READERS if not given.reader or reader.name in given.reader]
    if given.input is not None:
        _again(readers[0], seed, given.input)
        return 0
    print(f"seed {seed}, {given.inputs} inputs for each of {len(readers)} readers", flush=True)
    begin = time.monotonic()
    with ThreadPoolExecutor(given.jobs) as pool:
        work = partial(_run, seed=seed, inputs=given.inputs, limit_s=60 * given.minutes)
        problems = sum(pool.map(work, readers))
    print(f"{problems} failures in {time.monotonic() - begin:.0f} s (seed {seed})")
    return 1 if problems else 0


if __name__ == "__main__":
    raise SystemExit(main())
