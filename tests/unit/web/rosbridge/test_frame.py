from __future__ import annotations

import base64
import io
import json
import math
from typing import Any

import pytest

from zbot.web.rosbridge.frame import cbor, cbor_value, frames, typed_array

from geometry_msgs.msg import Vector3
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import Byte, ByteMultiArray, Int64

MESSAGE = {"op": "publish", "topic": "/a", "msg": {"data": "Grüße, " * 40}}


def joined(parts: list[Any]) -> Any:
    """Return the message in fragments, as a client joins them."""
    fragments = [json.loads(part) for part in parts]
    assert {fragment["op"] for fragment in fragments} == {"fragment"}
    assert {fragment["total"] for fragment in fragments} == {len(fragments)}
    assert len({fragment["id"] for fragment in fragments}) == 1
    assert [fragment["num"] for fragment in fragments] == list(range(len(fragments)))
    return json.loads("".join(fragment["data"] for fragment in fragments))


def test_a_short_message_is_one_frame() -> None:
    assert [json.loads(frame) for frame in frames(MESSAGE, fragment_size=10_000)] == [MESSAGE]


def test_a_long_message_is_in_fragments() -> None:
    parts = frames(MESSAGE, fragment_size=50)
    assert len(parts) > 5
    assert joined(parts) == MESSAGE


def test_the_number_of_fragments_is_limited() -> None:
    long = {"op": "publish", "msg": {"data": "x" * 100_000}}
    parts = frames(long, fragment_size=1)
    assert len(parts) <= 10_000
    assert joined(parts) == long


@pytest.mark.parametrize("text", ["", "x", "Grüße, " * 1000])
def test_png_has_the_message_in_its_colours(text: str) -> None:
    image = pytest.importorskip("PIL.Image", reason='PNG needs Pillow: pip install "zbot[web]"')
    [frame] = frames({"op": text}, "png")
    fields = json.loads(frame)
    assert fields["op"] == "png"
    picture = image.open(io.BytesIO(base64.b64decode(fields["data"]))).convert("RGB")
    assert json.loads(picture.tobytes().decode().rstrip("\n")) == {"op": text}


def test_cbor_is_bytes() -> None:
    assert frames({"op": "publish"}, "cbor") == [b"\xa1\x62op\x67publish"]


# The bytes of the first rows are those of RFC 8949, appendix A, and RFC 8746.
@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (0, "00"),
        (23, "17"),
        (24, "1818"),
        (1000, "1903e8"),
        (1_000_000, "1a000f4240"),
        (2**64 - 1, "1bffffffffffffffff"),
        (-1, "20"),
        (-1000, "3903e7"),
        (-(2**64), "3bffffffffffffffff"),
        (1.1, "fb3ff199999999999a"),
        (math.inf, "f97c00"),
        (False, "f4"),
        (True, "f5"),
        (None, "f6"),
        (bytes.fromhex("01020304"), "4401020304"),
        ("ü", "62c3bc"),
        ([1, [2, 3]], "8201820203"),
        ({"a": 1, "b": [2, 3]}, "a26161016162820203"),
        (typed_array("H", [1, 2]), "d8454401000200"),
        (typed_array("f", [1.5]), "d855440000c03f"),
    ],
)
def test_values_have_the_bytes_of_the_standard(value: Any, expected: str) -> None:
    assert cbor(value).hex() == expected


def test_octets_are_bytes_and_numbers_typed_arrays() -> None:
    assert cbor_value(Image(data=[1, 2]))["data"] == b"\x01\x02"
    assert cbor_value(ByteMultiArray(data=[b"a", b"b"]))["data"] == b"ab"
    assert cbor_value(LaserScan(ranges=[1.5]))["ranges"].value == bytes.fromhex("0000c03f")
    assert cbor_value(Byte(data=b"\x07")) == {"data": 7}
    assert cbor_value(Int64(data=-5)) == {"data": -5}
    assert cbor(cbor_value(Vector3(x=1.0)))[:2] == bytes.fromhex("a361")
