"""Tests of the CDR codec: bytes of Fast CDR, and any bytes without a crash."""

from __future__ import annotations

import json
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import zbot  # noqa: F401 - makes the messages importable
from tests.unit.wire.cdr.reference_cdr import reference_cdr
from tests.unit.wire.picky import Picky
from zbot.errors import ExternalShutdownException
from zbot.interfaces import get_message
from zbot.interfaces.errors import NotAMessageTypeError
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import register_spec
from zbot.wire import serialization
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.serialization import deserialize_message, is_cdr, serialize_message

from example_interfaces.msg import WString
from geometry_msgs.msg import Point32, Polygon, PoseStamped
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, Empty, Int32, String, UInt8MultiArray
from std_srvs.srv import SetBool
from test_msgs.msg import MultiNested

#: Bytes of Fast CDR; its undefined padding is set to zero.
VECTORS = json.loads((Path(__file__).parents[1] / "cdr_vectors.json").read_text(encoding="utf-8"))
TYPES = [LaserScan, PoseStamped, String, UInt8MultiArray, Empty]


@pytest.mark.parametrize("vector", VECTORS, ids=[vector["name"] for vector in VECTORS])
def test_bytes_are_those_of_fast_cdr(vector: dict[str, Any]) -> None:
    codec = cdr_codec_for(get_message(vector["type"]))
    data = bytes.fromhex(vector["cdr"])
    message = codec.decode(data)
    written = codec.encode(message)
    assert written == data[: len(written)]
    assert set(data[len(written) :]) <= {0}


def test_bytes_behind_the_message_are_ignored() -> None:
    data = serialize_message(String(data="hi"))
    assert deserialize_message(data + b"rest", String) == String(data="hi")


def test_big_endian_is_read() -> None:
    assert deserialize_message(bytes.fromhex("0000000000000003686900"), String).data == "hi"


@given(st.binary(max_size=200), st.sampled_from(TYPES))
def test_any_bytes_give_a_message_or_one_error(data: bytes, message_class: type[Any]) -> None:
    for prefix in (b"", b"\x00\x01\x00\x00", b"\x00\x00\x00\x00"):
        try:
            message = deserialize_message(prefix + data, message_class)
        except CodecError:
            continue
        assert deserialize_message(serialize_message(message), message_class) is not None


@given(st.binary(max_size=100))
def test_a_messagepack_message_is_not_detected_as_cdr(data: bytes) -> None:
    assert is_cdr(serialize_message(UInt8MultiArray(data=data)))
    assert not is_cdr(messagepack_codec_for(UInt8MultiArray).encode(UInt8MultiArray(data=data)))


def test_a_wrong_sequence_length_allocates_no_memory() -> None:
    with pytest.raises(CodecError, match="longer than the bytes that follow"):
        deserialize_message(b"\x00\x01\x00\x00" + b"\xff\xff\xff\xff", String)


def test_a_message_of_another_class_is_refused() -> None:
    with pytest.raises(CodecError, match="cannot encode"):
        cdr_codec_for(PoseStamped).encode(String())  # type: ignore[arg-type]


def test_a_service_is_not_a_message() -> None:
    with pytest.raises(NotAMessageTypeError):
        cdr_codec_for(SetBool)


@dataclass
class Leg:
    length: float = 0.0
    name: str = ""
    angles: list[float] = field(default_factory=list)


@dataclass
class Spider:
    flag: bool = False
    data: bytes = b""
    main: Leg = field(default_factory=Leg)
    legs: list[Leg] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    code: Annotated[str, "string<=3"] = ""
    pair: Annotated[list[str], "string[2]"] = field(default_factory=lambda: ["a", "b"])
    few: Annotated[list[int], "uint8[<=2]"] = field(default_factory=list)
    gains: Annotated[list[float], "float32[3]"] = field(default_factory=lambda: [0.5] * 3)


def test_dataclasses_are_messages() -> None:
    legs = [Leg(1.5, "left", [0.5]), Leg()]
    spider = Spider(True, b"abc", legs[0], legs, ["a", "", "bcd"], "abc", ["x", "y"], [1, 2])
    codec = cdr_codec_for(Spider)
    data = codec.encode(spider)
    assert data == reference_cdr(spider)
    assert codec.decode(data) == spider
    assert codec.decode(reference_cdr(spider, ">")) == spider


def test_ndarrays_of_any_form_are_written() -> None:
    numpy = pytest.importorskip("numpy")
    codec = cdr_codec_for(Spider)
    expected = codec.encode(Spider(gains=[1.0, 2.0, 3.0], few=[1, 2]))
    gains, few = numpy.array([1, 0, 2, 0, 3, 0], "float32")[::2], numpy.array([1, 2], "uint8")
    assert codec.encode(Spider(gains=gains, few=few)) == expected
    swapped = Spider(gains=numpy.array([1, 2, 3], ">f4"))
    with pytest.raises(CodecError, match="'gains': expected an array of typecode 'f'"):
        codec.encode(swapped)


@pytest.mark.parametrize(
    ("spider", "place"),
    [
        (Spider(flag=1), "flag"),  # type: ignore[arg-type]
        (Spider(main=Leg(length="1")), "main.length"),  # type: ignore[arg-type]
        (Spider(legs=[Leg(), Leg(name="\ud800")]), "legs[1].name"),
        (Spider(legs=[Leg(), Leg(name=b"a")]), "legs[1].name"),  # type: ignore[arg-type]
        (Spider(legs=[None]), "legs[0]"),  # type: ignore[list-item]
        (Spider(names=["a", 5]), "names[1]"),  # type: ignore[list-item]
        (Spider(code="four"), "code"),
        (Spider(pair=["a"]), "pair"),
        (Spider(few=[1, 2, 3]), "few"),
        (Spider(few=[256]), "few[0]"),
        (Spider(gains=[1.0]), "gains"),
    ],
)
def test_a_wrong_value_is_refused_and_its_field_is_named(spider: Spider, place: str) -> None:
    with pytest.raises(CodecError, match="cannot encode") as raised:
        cdr_codec_for(Spider).encode(spider)
    assert raised.value.field == place


@pytest.mark.parametrize(
    ("message_class", "body", "reason"),
    [
        (Bool, "02", "2 is not a bool"),
        (String, "03000000 ffff00", "a text is not valid UTF-8"),
        (String, "04000000 616200", "a text is longer than the bytes that follow"),
        (String, "0400", "the bytes end before the message does"),
        (Int32, "010000", "the bytes end before the message does"),
        (Empty, "", "the bytes end before the message does"),
        (WString, "01000000 00000100", "a wide text is not valid UTF-16"),
        (WString, "01000000 00d80000", "a wide text is not valid UTF-16"),
        (Polygon, "02000000" + "00" * 12, "a sequence is longer than the bytes that follow"),
        (Spider, "02000000 00000000", "2 is not a bool"),
    ],
)
def test_wrong_bytes_are_refused_with_the_reason(
    message_class: type[Any], body: str, reason: str
) -> None:
    with pytest.raises(CodecError, match=reason):
        cdr_codec_for(message_class).decode_strictly(b"\0\1\0\0" + bytes.fromhex(body))


@pytest.mark.parametrize(
    ("message_class", "body", "value"),
    [
        (Bool, "02", True),
        (Bool, "ff", True),
        (String, "05000000 636166e9 00", "caf\ufffd"),
        (String, "04000000 fffe61 00", "\ufffd\ufffda"),
        (String, "04000000 61e282 00", "a\ufffd"),
        (String, "06000000 61eda08062 00", "a\ufffd\ufffd\ufffdb"),
        (WString, "01000000 00d80000", "\ufffd"),
    ],
)
@pytest.mark.parametrize("order", ["little", "big"])
def test_values_that_are_not_valid_are_read_as_in_rclpy(
    message_class: type[Any], body: str, value: object, order: str
) -> None:
    data, header = bytes.fromhex(body), b"\0\1\0\0"
    if order == "big":
        numbers = {Bool: 0, String: 4, WString: 8}[message_class]  #: their bytes at the beginning
        swapped = [data[begin : begin + 4][::-1] for begin in range(0, numbers, 4)]
        data, header = b"".join(swapped) + data[numbers:], bytes(4)
    assert cdr_codec_for(message_class).decode(header + data).data == value


def test_values_of_inner_messages_that_are_not_valid_are_read_too() -> None:
    nested = cdr_codec_for(MultiNested)
    good = MultiNested()
    good.array_of_arrays[1].string_values = ["QQQQ", "b", "c"]
    good.array_of_arrays[1].bool_values = [True, True, True]
    data = nested.encode(good).replace(b"QQQQ", b"Q\xe9QQ").replace(b"\1\1\1", b"\2\3\1")
    with pytest.raises(CodecError):
        nested.decode_strictly(data)
    found = nested.decode(data).array_of_arrays[1]
    assert found.string_values[0] == "Q\ufffdQQ"
    assert found.bool_values == [True, True, True]


def test_a_message_that_is_read_with_replacements_causes_one_warning() -> None:
    data = b"\0\1\0\0\5\0\0\0caf\xe9\0"
    serialization._warned.clear()
    with pytest.warns(UserWarning, match="of std_msgs/msg/String is not valid: a text is not va"):
        assert deserialize_message(data, String).data == "caf\ufffd"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert deserialize_message(data, String).data == "caf\ufffd"


@pytest.mark.parametrize("data", [b"", b"\0", b"\0\1", b"\0\1\0", b"\0\2\0\0\0", b"\x80\0\0\0\0"])
def test_bytes_without_a_header_are_refused(data: bytes) -> None:
    with pytest.raises(CodecError, match="do not begin with a CDR header"):
        cdr_codec_for(Empty).decode(data)


def test_lengths_beyond_the_bounds_are_refused() -> None:
    @dataclass
    class Bounded:
        code: Annotated[str, "string<=3"] = ""
        few: Annotated[list[int], "uint8[<=2]"] = field(default_factory=list)
        names: Annotated[list[str], "string[<=1]"] = field(default_factory=list)

    @dataclass
    class Unbounded:
        code: str = ""
        few: Annotated[list[int], "uint8[]"] = field(default_factory=list)
        names: list[str] = field(default_factory=list)

    for name, value in {"code": "four", "few": [1, 2, 3], "names": ["a", "b"]}.items():
        data = cdr_codec_for(Unbounded).encode(Unbounded(**{name: value}))  # type: ignore[arg-type]
        with pytest.raises(CodecError, match="at most") as raised:
            cdr_codec_for(Bounded).decode(data)
        assert raised.value.field == name


def test_a_text_without_nul_is_read() -> None:
    data = b"\0\1\0\0" + bytes.fromhex("02000000 6869")
    assert deserialize_message(data, String).data == "hi"
    assert deserialize_message(b"\0\1\0\0" + bytes(4), String).data == ""


def test_wide_texts_have_four_bytes_for_each_unit() -> None:
    data = serialize_message(WString(data="aé€"))
    assert data == bytes.fromhex("00010000 03000000 61000000 e9000000 ac200000")
    assert deserialize_message(data, WString).data == "aé€"


def test_a_list_that_got_a_wrong_element_is_refused() -> None:
    polygon = Polygon(points=[Point32()])
    polygon.points.append(None)  # type: ignore[arg-type]
    with pytest.raises(CodecError, match=r"'points\[1\]'"):
        serialize_message(polygon)


def test_types_inside_types_many_times_have_a_short_source() -> None:
    # With one source for all, there would be 2**24 copies of the last type's fields.
    register_spec(parse("many_msgs/msg/Level24", "string text\nfloat64 number"))
    for level in reversed(range(24)):
        inner = f"Level{level + 1}"
        register_spec(
            parse(f"many_msgs/msg/Level{level}", f"bool a\n{inner}[] left\n{inner}[] right")
        )
    classes = [get_message(f"many_msgs/msg/Level{level}") for level in range(25)]
    message: Any = classes[24](text="end", number=0.5)
    for index, message_class in enumerate(reversed(classes[:24])):
        message = message_class(**{("left", "right")[index % 2]: [message]})
    codec = cdr_codec_for(classes[0])
    data = codec.encode(message)
    assert data == reference_cdr(message)
    assert codec.decode(data) == message
    assert codec.decode(reference_cdr(message, ">")) == message
    with pytest.raises(CodecError):
        codec.decode(data[:-1])


def test_an_error_in_a_dataclass_constructor_is_a_codec_error() -> None:
    data = cdr_codec_for(Picky).encode(Picky(12))
    with pytest.raises(CodecError, match="KeyError: 'thirteen'"):
        cdr_codec_for(Picky).decode(data.replace(b"\x0c", b"\x0d"))
    with pytest.raises(ExternalShutdownException):  # a signal during decoding
        cdr_codec_for(Picky).decode(data.replace(b"\x0c", b"\x0f"))
