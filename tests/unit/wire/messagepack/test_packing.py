from __future__ import annotations

import struct
import time
import tracemalloc
from array import array
from typing import Any

import msgpack  # type: ignore[import-untyped]
import pytest

from tests.conftest import allowed
from zbot.wire.messagepack import packing
from zbot.wire.messagepack.packing import (
    Extension,
    UnreadableError,
    bin_header,
    ext_header,
    map_header,
    read_array,
    unpack,
)
from zbot.wire.messagepack.value_reader import read_texts

packed: Any = msgpack.packb


@pytest.mark.parametrize("count", [0, 15, 16, 70_000 // 2])
def test_map_headers_equal_those_of_msgpack(count: int) -> None:
    keys = {str(key): 0 for key in range(count)}
    assert packed(keys).startswith(map_header(count))


@pytest.mark.parametrize("size", [0, 1, 2, 3, 4, 8, 16, 17, 255, 256, 65535, 65536])
def test_array_headers_equal_those_of_msgpack(size: int) -> None:
    data = bytes(size)
    assert bin_header(size) + data == packed(data)
    assert ext_header(102, size) + data == packed(msgpack.ExtType(102, data))


@pytest.mark.parametrize("typecode", "bBhHiIqQfd")
def test_arrays_are_little_endian_with_standard_sizes(typecode: str) -> None:
    data = struct.pack(f"<2{typecode}", 1, 2)
    assert read_array(typecode, data) == array(typecode, [1, 2])
    assert unpack(packed(msgpack.ExtType(ord(typecode), data))) == array(typecode, [1, 2])


def test_a_big_endian_machine_swaps_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(packing, "BIG_ENDIAN", True)
    assert read_array("H", b"\1\2") == array("H", b"\2\1")


@pytest.mark.parametrize(("code", "data"), [(99, b"12345678"), (ord("d"), b"123"), (-5, b"")])
def test_foreign_extensions_are_kept_apart(code: int, data: bytes) -> None:
    assert unpack(packed(msgpack.ExtType(code & 0x7F, data))) == Extension(code & 0x7F, data)


def test_long_lists_are_read() -> None:
    assert unpack(packed(list(range(5000)))) == list(range(5000))


def test_wrong_lengths_in_headers_allocate_no_memory() -> None:
    bomb = b"\xdd\x00\x0f\x00\x00" * 900 + bytes(1_000_000)
    tracemalloc.start()
    with pytest.raises(UnreadableError):
        unpack(bomb)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 50_000_000


def test_many_lists_of_long_texts_take_little_time() -> None:
    texts = ["a" * 200] * 13
    data = b"".join(map(packed, texts)) + bytes(16 * 2**20)
    begin = time.process_time()
    for _ in range(2000):  # each of them copied the 16 MB
        assert read_texts(data, 0, 13) == (texts, 13 * 202)
    assert time.process_time() - begin < allowed(3)
