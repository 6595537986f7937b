"""Mutation fuzzer. Each input depends only on the seed, the reader and the input's number."""

from __future__ import annotations

import time
import traceback
from dataclasses import dataclass
from random import Random
from typing import TYPE_CHECKING

from tests.conftest import allowed

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from tests.torture.reader import Reader

MAX_BYTES = 65_536
_MOST_MUTATIONS = 6
#: Parts that have a meaning in the formats that zbot reads.
_TOKENS = (
    *(b"[", b"]", b"{", b"}", b"(", b")", b'"', b"'", b":", b",", b"\n", b"\0", b"\\", b"#", b"/"),
    *(b"-1", b"0", b"1e999", b"NaN", b"Infinity", b".inf", b"-.inf", b"9" * 30, b"9" * 5000),
    *(b"4294967295", b"18446744073709551616", b"0x", b"null", b"true", b"~", b"\\ud800"),
    *(b"&a ", b"*a", b"<<: ", b"!!int ", b"!!binary ", b"!!set ", b"? ", b"- ", b"---\n"),
    *(b"${A}", b"set(A ${A}${A})\n", b"$(var a)", b"%s", b"{0}", b"[x for x in a]", b"a + a"),
    *(b"<!ENTITY a 'b'>", b"&amp;", b"&a;", b"<a>", b"</a>", b"<?xml encoding='utf-16'?>"),
    *(b"\xff", b"\xed\xa0\x80", b"\xef\xbb\xbf", b"\xc0\x80", b"\xf0\x9f\xa4\x96", b"\xe2\x80\xa8"),
    *(
        b"\x80",
        b"\x81",
        b"\x90",
        b"\xc0",
        b"\xc1",
        b"\xdd\xff\xff\xff\xff",
        b"\xdf\xff\xff\xff\xff",
    ),
    *(b"\xc9\xff\xff\xff\xff", b"\xcf" + b"\xff" * 8, b"\x7f\xff\xff\xff", b"\xff\xff\xff\xff"),
    *(b" AND ", b" OR ", b"NOT ", b"LIKE ", b"[0]", b"[-1:]", b"..", b"__", b"../", b"msg/"),
)


# Most inputs are short, so that more of them can be read.
_REPETITIONS = (*([1] * 20), 2, 3, 9, 60, 400, 30_000)


@dataclass(frozen=True)
class Failure:
    """An input that a reader neither accepted nor refused with its named error in time."""

    reader: str
    seed: str
    number: int
    problem: str

    @property
    def command(self) -> str:
        """Command that runs this input again."""
        words = f"--reader {self.reader} --seed {self.seed} --input {self.number}"
        return f"python -m tests.torture {words}"

    def __str__(self) -> str:
        return f"{self.problem}\n  again: {self.command}"


def input_of(reader: Reader, seed: str, number: int) -> bytes:
    """Return an input. The first inputs are the reader's seeds without a change."""
    if number < len(reader.seeds):
        return reader.seeds[number]
    random = Random(f"{seed}/{reader.name}/{number}")
    if random.random() < 0.02:
        return random.randbytes(random.randrange(200))
    data = random.choice(reader.seeds)
    for _ in range(random.randint(1, _MOST_MUTATIONS)):
        data = _mutated(data, reader, random)[:MAX_BYTES]
    return data


def _mutated(data: bytes, reader: Reader, random: Random) -> bytes:
    change: Callable[[bytes, Reader, Random], bytes] = random.choice(_MUTATIONS)
    return change(data, reader, random)


def _slice(data: bytes, random: Random) -> tuple[int, int]:
    begin = random.randint(0, len(data))
    return begin, min(len(data), begin + random.choice((1, 1, 2, 4, 8, 30, 200)))


def _byte(data: bytes, _: Reader, random: Random) -> bytes:
    begin, _end = _slice(data, random)
    return data[:begin] + bytes((random.randrange(256),)) + data[begin + 1 :]


def _bit(data: bytes, _: Reader, random: Random) -> bytes:
    if not data:
        return data
    place = random.randrange(len(data))
    return data[:place] + bytes((data[place] ^ 1 << random.randrange(8),)) + data[place + 1 :]


def _removed(data: bytes, _: Reader, random: Random) -> bytes:
    begin, end = _slice(data, random)
    return data[:begin] + data[end:]


def _truncated(data: bytes, _: Reader, random: Random) -> bytes:
    return data[: random.randint(0, len(data))]


def _repeated(data: bytes, _: Reader, random: Random) -> bytes:
    begin, end = _slice(data, random)
    times = random.choice((1, 1, 1, 1, 2, 2, 7, 60, 2000))
    return data[:end] + data[begin:end] * times + data[end:]


def _token(data: bytes, _: Reader, random: Random) -> bytes:
    begin, end = _slice(data, random)
    token = random.choice(_TOKENS) * random.choice(_REPETITIONS)
    return data[:begin] + token + data[random.choice((begin, end)) :]


def _spliced(data: bytes, reader: Reader, random: Random) -> bytes:
    other = random.choice(reader.seeds)
    return data[: random.randint(0, len(data))] + other[random.randint(0, len(other)) :]


def _moved(data: bytes, _: Reader, random: Random) -> bytes:
    begin, end = _slice(data, random)
    rest = data[:begin] + data[end:]
    place = random.randint(0, len(rest))
    return rest[:place] + data[begin:end] + rest[place:]


_MUTATIONS = (_byte, _bit, _removed, _truncated, _repeated, _token, _token, _spliced, _moved)


def problem_with(reader: Reader, data: bytes) -> str:
    """Return the problem of a reader with an input, or an empty string."""
    begin = time.process_time()
    problem = ""
    try:
        reader.call(data)
    except reader.errors as error:
        if not str(error):
            problem = f"{type(error).__name__} has no sentence"
    except Exception as error:  # noqa: BLE001 - any other exception is what the fuzzer looks for
        last = traceback.extract_tb(error.__traceback__)[-1]
        problem = f"{type(error).__name__}: {error!s:.200} ({last.filename}:{last.lineno})"
    took_s = time.process_time() - begin
    if took_s > allowed(reader.limit_s) and not problem:
        problem = f"took {took_s:.1f} s for {len(data)} bytes"
    return problem


def failures(
    reader: Reader, seed: str, numbers: Iterable[int], note: Callable[[int], None] = lambda _: None
) -> Iterator[Failure]:
    """Yield the failures of a reader. `note` gets each number before its input is read."""
    for number in numbers:
        note(number)
        problem = problem_with(reader, input_of(reader, seed, number))
        if problem:
            yield Failure(reader.name, seed, number, problem)
