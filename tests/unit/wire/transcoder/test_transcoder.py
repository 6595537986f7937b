"""Tests of the transcoder: it agrees with the two codecs for every type and any bytes."""

from __future__ import annotations

import json
import math
import random
import struct
from array import array
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import msgpack  # type: ignore[import-untyped]
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.unit.wire.random_message import random_message, shipped_messages
from zbot.interfaces import get_interface, get_message
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.transcoder.transcoder import to_cdr, to_messagepack

packb: Any = msgpack.packb
VECTORS = json.loads((Path(__file__).parents[1] / "cdr_vectors.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("part", range(4))
def test_bytes_are_those_of_the_codecs(part: int) -> None:
    for name in shipped_messages()[part::4]:
        cls, chance = get_interface(name), random.Random(name)
        for message in (cls(), random_message(cls, chance)):
            cdr = cdr_codec_for(cls).encode(message)
            # A default such as 0.3 is not exact in a float32. MessagePack would keep it as it is.
            packed = messagepack_codec_for(cls).encode(cdr_codec_for(cls).decode(cdr))
            assert to_cdr(cls)(packed) == cdr, name
            assert to_messagepack(cls)(cdr) == packed, name


@pytest.mark.parametrize("vector", VECTORS, ids=[vector["name"] for vector in VECTORS])
def test_bytes_of_fast_cdr_are_read(vector: dict[str, Any]) -> None:
    cls, data = get_message(vector["type"]), bytes.fromhex(vector["cdr"])
    packed = messagepack_codec_for(cls).encode(cdr_codec_for(cls).decode(data))
    assert to_messagepack(cls)(data) == packed
    assert data.startswith(to_cdr(cls)(packed))


def test_no_message_object_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    imu = get_message("sensor_msgs/msg/Imu")
    packed, cdr = messagepack_codec_for(imu).encode(imu()), cdr_codec_for(imu).encode(imu())
    there, back = to_cdr(imu), to_messagepack(imu)
    # A slot is restored afterwards. A class would keep the `__new__` that it did not have before.
    refusing = property(fset=lambda *_: pytest.fail("a message object was made"))
    monkeypatch.setattr(imu, "_header", refusing)
    assert there(packed) == cdr
    assert back(cdr) == packed


def test_a_missing_field_gets_its_default() -> None:
    point = get_message("geometry_msgs/msg/Point")
    assert to_cdr(point)(packb({"y": 2.0}))[4:] == struct.pack("<3d", 0, 2, 0)


def test_a_list_of_numbers_is_accepted() -> None:
    cls: Any = get_message("std_msgs/msg/Int16MultiArray")
    data = packb({"data": [1, -2]})
    assert cdr_codec_for(cls).decode(to_cdr(cls)(data)).data == array("h", [1, -2])


@dataclass
class Leg:
    angles: list[float] = field(default_factory=list)


@dataclass
class Spider:
    is_alive: bool = False
    name: str = ""
    legs: list[Leg] = field(default_factory=list)
    gains: Annotated[list[float], "float32[2]"] = field(default_factory=lambda: [0.0] * 2)


def test_dataclasses_are_converted_and_bytes_after_the_message_are_ignored() -> None:
    spider = Spider(True, "tegenaria", [Leg([0.5, 1.0]), Leg()], [1.5, 2.5])
    packed, cdr = messagepack_codec_for(Spider).encode(spider), cdr_codec_for(Spider).encode(spider)
    assert to_cdr(Spider)(packed) == cdr
    assert to_messagepack(Spider)(cdr + b"more") == packed


def test_big_endian_is_read() -> None:
    cls: Any = get_message("std_msgs/msg/Float64MultiArray")
    data = b"\0\0\0\0" + struct.pack(">IIIId", 0, 0, 1, 0, 1.5)
    assert messagepack_codec_for(cls).decode(to_messagepack(cls)(data)).data == array("d", [1.5])


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("std_msgs/msg/Bool", {"data": "yes"}),
        ("std_msgs/msg/Int8", {"data": 300}),
        ("std_msgs/msg/Float32", {"data": 1e300}),
        ("std_msgs/msg/String", {"data": 3}),
        ("std_msgs/msg/UInt8MultiArray", {"data": "text"}),
    ],
)
def test_a_wrong_value_is_refused(name: str, values: dict[str, Any]) -> None:
    with pytest.raises(CodecError, match="data"):
        to_cdr(get_message(name))(packb(values))


def test_not_a_number_and_infinity_stay() -> None:
    cls = get_message("std_msgs/msg/Float32")
    for value in (math.inf, -math.inf, math.nan):
        data = cdr_codec_for(cls).encode(cls(data=value))
        assert to_cdr(cls)(to_messagepack(cls)(data)) == data


FEW = ["std_msgs/msg/String", "sensor_msgs/msg/LaserScan", "test_msgs/msg/UnboundedSequences"]


@given(st.binary(max_size=200), st.sampled_from(FEW))
def test_any_bytes_give_what_the_codecs_give(data: bytes, name: str) -> None:
    cls = get_message(name)
    for convert, decode, prefix in (
        (to_messagepack(cls), cdr_codec_for(cls).decode, b"\0\1\0\0"),
        (to_cdr(cls), messagepack_codec_for(cls).decode, b""),
    ):
        try:
            converted = convert(prefix + data)
        except CodecError:
            with pytest.raises(CodecError):
                decode(prefix + data)
        else:
            decode(prefix + data)
            assert converted
