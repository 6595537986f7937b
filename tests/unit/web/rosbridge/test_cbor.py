from __future__ import annotations

import math
from typing import Any

import pytest

from zbot.web.rosbridge.cbor import cbor_value, encode, typed_array

from geometry_msgs.msg import Vector3
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import Byte, ByteMultiArray, Int64


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
    assert encode(value).hex() == expected


def test_octets_are_bytes_and_numbers_typed_arrays() -> None:
    assert cbor_value(Image(data=[1, 2]))["data"] == b"\x01\x02"
    assert cbor_value(ByteMultiArray(data=[b"a", b"b"]))["data"] == b"ab"
    assert cbor_value(LaserScan(ranges=[1.5]))["ranges"].value == bytes.fromhex("0000c03f")
    assert cbor_value(Byte(data=b"\x07")) == {"data": 7}
    assert cbor_value(Int64(data=-5)) == {"data": -5}
    assert encode(cbor_value(Vector3(x=1.0)))[:2] == bytes.fromhex("a361")
