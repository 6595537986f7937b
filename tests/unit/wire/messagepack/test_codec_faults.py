from __future__ import annotations

import math
import time
from array import array
from traceback import format_exception
from typing import Any

import msgpack  # type: ignore[import-untyped]
import pytest

import zbot  # noqa: F401 - makes the messages importable
from tests.unit.wire.messagepack.coded import decode, encode
from zbot.interfaces import get_message, register_spec
from zbot.interfaces.parser import parse_message
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.messagepack.packing import pack

from geometry_msgs.msg import Pose, Twist
from nav_msgs.msg import Odometry, Path
from sensor_msgs.msg import Image, JointState, LaserScan
from std_msgs.msg import Bool, Byte, ByteMultiArray, Float32, Float64, String, UInt8
from test_msgs.msg import MultiNested
from visualization_msgs.msg import Marker, MarkerArray


def made(name: str, text: str) -> Any:
    """Return the class of a definition that exists only in these tests."""
    register_spec(parse_message(f"codec_tests/msg/{name}", text))
    return get_message(f"codec_tests/msg/{name}")


def test_absent_fields_get_their_defaults() -> None:
    message_class = made("Defaults", 'float64 speed 1.5\nint32[] ids [1, 2]\nstring name "n"\n')
    assert decode(message_class, {}) == message_class()
    assert decode(message_class, {"speed": 2.0}).ids == array("i", [1, 2])


def test_unknown_fields_are_ignored() -> None:
    value = {"data": "x", "new": {"deep": [1, {"er": msgpack.ExtType(99, b"?")}]}}
    assert decode(String, value) == String(data="x")


def test_plain_lists_of_numbers_are_accepted() -> None:
    scan = decode(LaserScan, {"ranges": [1, 2.5, math.inf], "intensities": []})
    assert scan.ranges == array("f", [1.0, 2.5, math.inf])
    assert decode(Image, {"data": [1, 255]}).data == array("B", [1, 255])
    assert list(decode(Odometry, {"pose": {"covariance": [1] * 36}}).pose.covariance) == [1.0] * 36
    assert len(decode(LaserScan, {"ranges": [0.5] * 5000}).ranges) == 5000


def test_an_integer_is_accepted_for_a_float_field() -> None:
    assert decode(Float32, {"data": 3}).data == 3.0
    assert type(decode(Float32, {"data": 3}).data) is float


def test_bytes_may_come_as_numbers_or_binaries() -> None:
    byte = Byte
    assert decode(byte, {"data": 7}) == decode(byte, {"data": b"\x07"}) == byte(data=b"\x07")
    assert decode(ByteMultiArray, {"data": [1, b"\2"]}).data == [b"\1", b"\2"]


@pytest.mark.parametrize(
    ("message_class", "value", "field", "reason"),
    [
        (String, {"data": 5}, "data", "expected a string, not int 5"),
        (String, {"data": None}, "data", "expected a string, not NoneType None"),
        (String, {"data": b"x"}, "data", "expected a string, not bytes b'x'"),
        (String, {"data": "x" * 100, "a": 1}["data"] and [], "", "expected a map, not list"),
        (String, 5, "", "expected a map, not int 5"),
        (Float32, {"data": "1"}, "data", "expected a number, not str '1'"),
        (Float32, {"data": True}, "data", "expected a number, not bool True"),
        (Float32, {"data": 1e300}, "data", "out of range for a float32"),
        (UInt8, {"data": 256}, "data", "int 256 is not in the range 0 to 255"),
        (UInt8, {"data": -1}, "data", "int -1 is not in the range 0 to 255"),
        (UInt8, {"data": 1.0}, "data", "expected an integer, not float 1.0"),
        (UInt8, {"data": True}, "data", "expected an integer, not bool True"),
        (Bool, {"data": 1}, "data", "expected a bool, not int 1"),
        (Byte, {"data": b"xy"}, "data", "expected one byte"),
        (Byte, {"data": 256}, "data", "not in the range 0 to 255"),
        (Twist, {"linear": 5}, "linear", "expected a map, not int 5"),
        (Twist, {"linear": {"x": "a"}}, "linear.x", "expected a number"),
        (Path, {"poses": 5}, "poses", "expected a list, not int 5"),
        (Path, {"poses": [{}, 5]}, "poses[1]", "expected a map"),
        (
            Path,
            {"poses": [{}, {"header": {"stamp": {"sec": 2**31}}}]},
            "poses[1].header.stamp.sec",
            "is not in the range",
        ),
        (JointState, {"name": ["a", 5]}, "name[1]", "expected a string, not int 5"),
        (JointState, {"position": [1.0, "b"]}, "position[1]", "expected a number"),
        (JointState, {"position": b"\0"}, "position", "expected a list, not bytes"),
        (Image, {"data": msgpack.ExtType(ord("f"), b"\0\0\0\0")}, "data", "not of typecode 'f'"),
        (Image, {"data": [1, 256]}, "data[1]", "not in the range 0 to 255"),
        (LaserScan, {"ranges": [1e300]}, "ranges[0]", "out of range for a float32"),
        (LaserScan, {"ranges": [True]}, "ranges[0]", "expected a number, not bool"),
        (
            LaserScan,
            {"ranges": msgpack.ExtType(ord("f"), b"\0\0\0")},
            "ranges",
            "an extension with code 102",
        ),
        (Odometry, {"pose": {"covariance": [1.0]}}, "pose.covariance", "exactly 36 are needed"),
        (ByteMultiArray, {"data": 5}, "data", "expected a list"),
    ],
)
def test_a_wrong_value_is_named_with_its_field(
    message_class: Any, value: Any, field: str, reason: str
) -> None:
    with pytest.raises(CodecError) as caught:
        decode(message_class, value)
    assert caught.value.field == field
    assert caught.value.action == "decode"
    assert reason in caught.value.reason


def test_bounds_are_checked_on_arrival() -> None:
    bounded = made("Bounded", "string<=3 name\nint32[<=2] ids\nbool[2] flags\nstring<=3[] names\n")
    assert decode(bounded, {"name": "abc", "ids": [1, 2]}) == bounded(name="abc", ids=[1, 2])
    for value, field in [
        ({"name": "abcd"}, "name"),
        ({"ids": [1, 2, 3]}, "ids"),
        ({"ids": msgpack.ExtType(ord("i"), bytes(12))}, "ids"),
        ({"flags": [True]}, "flags"),
        ({"flags": [True, 1]}, "flags[1]"),
        ({"names": ["abcd"]}, "names[0]"),
    ]:
        with pytest.raises(CodecError) as caught:
            decode(bounded, value)
        assert caught.value.field == field


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "not MessagePack"),
        (b"\xc1", "no meaning"),
        (b"\x81\xa4data", "not MessagePack"),
        (b"\x80\x80", "more bytes follow"),
        (b"\x81\xa4data\xa3\xed\xa0\x80", "not valid UTF-8"),
        (b"\x81\xa1\xff\x01", "not valid UTF-8"),
        (b"\x81\x01\x01", "not MessagePack"),
        (b"\x81\x90\x01", "not MessagePack"),
        (b"\x91" * 10_000_000, "nested too deeply"),
        (b"\x81\xa1a" * 1_000_000, "nested too deeply"),
        (b"\xdd\x00\x10\x00\x00" * 900 + bytes(2_000_000), "end before"),
        (b"\xdd\xff\xff\xff\xff", "end before"),
        (b"\xdf\xff\xff\xff\xff", "not MessagePack"),
        (b"\xc6\xff\xff\xff\xff", "not MessagePack"),
        (b"\x81\xa4data\xdb\xff\xff\xff\xff", "not MessagePack"),
        (b"\xd7\xff" + b"\xff" * 8, "not MessagePack"),
    ],
)
def test_invalid_bytes_are_a_codec_error(data: bytes, reason: str) -> None:
    for message_class in (String, Image):
        with pytest.raises(CodecError, match=reason):
            messagepack_codec_for(message_class).decode_strictly(data)
        if reason != "not valid UTF-8":
            with pytest.raises(CodecError, match=reason):
                messagepack_codec_for(message_class).decode(data)


@pytest.mark.parametrize(
    ("message_class", "data", "value"),
    [
        (String, b"\x81\xa4data\xa4caf\xe9", "caf\ufffd"),
        (String, b"\x81\xa4data\xd9\x04caf\xe9", "caf\ufffd"),
        (String, b"\x81\xa4data\xa3\xed\xa0\x80", "\ufffd\ufffd\ufffd"),
        (Bool, b"\x81\xa4data\x02", True),
        (Bool, b"\x81\xa4data\x00", False),
    ],
)
def test_values_that_are_not_valid_are_read_as_in_rclpy(
    message_class: type[Any], data: bytes, value: object
) -> None:
    assert messagepack_codec_for(message_class).decode(data).data == value
    with pytest.raises(CodecError):
        messagepack_codec_for(message_class).decode_strictly(data)


def test_values_of_inner_messages_that_are_not_valid_are_read_too() -> None:
    found = messagepack_codec_for(MultiNested).decode(
        b"\x81\xafarray_of_arrays\x93"
        b"\x80"
        b"\x82\xadstring_values\x93\xa1\xe9\xa1b\xa1c\xabbool_values\x93\x02\x00\xc3"
        b"\x80"
    )
    assert found.array_of_arrays[1].string_values == ["\ufffd", "b", "c"]
    assert found.array_of_arrays[1].bool_values == [True, False, True]


def test_a_payload_that_is_not_bytes_is_a_codec_error() -> None:
    with pytest.raises(CodecError):
        messagepack_codec_for(String).decode("text")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize(
    ("message_class", "path", "value", "field"),
    [
        (String, "_data", 5, "data"),
        (String, "_data", "\ud800", "data"),
        (UInt8, "_data", 300, "data"),
        (Float32, "_data", "x", "data"),
        (Float32, "_data", 1e300, "data"),
        (Twist, "_linear", None, "linear"),
        (Twist, "_linear._x", "a", "linear.x"),
        (Twist, "_linear", 10**400, "linear"),
        (Float64, "_data", 10**400, "data"),
        (Image, "_data", "pixels", "data"),
        (Image, "_data", array("f", [1.0]), "data"),
        (Image, "_header._frame_id", "a\udfffb", "header.frame_id"),
        (Path, "_poses", [None], "poses[0]"),
        (JointState, "_name", ["a", None], "name[1]"),
        (JointState, "_name", ["a", "\ud800"], "name[1]"),
        (JointState, "_position", [1.0, None], "position[1]"),
        (ByteMultiArray, "_data", [b"ab"], "data[0]"),
        (Odometry, "_pose._covariance", array("d", [1.0]), "pose.covariance"),
    ],
)
def test_an_invalid_message_is_not_sent(
    message_class: Any, path: str, value: Any, field: str
) -> None:
    message = message_class()
    *parents, name = path.split(".")
    owner = message
    for parent in parents:
        owner = getattr(owner, parent)
    setattr(owner, name, value)
    with pytest.raises(CodecError) as caught:
        encode(message)
    assert (caught.value.action, caught.value.field) == ("encode", field)


@pytest.mark.parametrize("codec_for", [messagepack_codec_for, cdr_codec_for])
def test_a_wrong_item_is_one_traceback(codec_for: Any) -> None:
    message = Path()
    message.poses.append(Pose())  # type: ignore[arg-type]
    with pytest.raises(CodecError, match="expected a geometry_msgs/msg/PoseStamped") as caught:
        codec_for(Path).encode(message)
    assert "Fault" not in "".join(format_exception(caught.value))


def test_an_object_of_another_class_is_not_sent() -> None:
    with pytest.raises(CodecError, match="expected a std_msgs/msg/String, not int 5"):
        messagepack_codec_for(String).encode(5)  # type: ignore[arg-type]


def test_a_message_without_its_attributes_is_not_sent() -> None:
    with pytest.raises(CodecError, match="_data"):
        encode(String.__new__(String))


def test_lists_in_place_of_arrays_are_sent_as_arrays() -> None:
    image: Any = Image()
    image._data = [1, 2]
    assert decode(Image, encode(image)).data == array("B", [1, 2])


def test_numpy_arrays_are_sent_whatever_their_layout() -> None:
    numpy = pytest.importorskip("numpy")
    state: Any = JointState()
    state._position = numpy.arange(6, dtype="float64")[::2]
    assert decode(JointState, encode(state)).position == array("d", [0.0, 2.0, 4.0])
    state._position = numpy.arange(3, dtype=">f8")
    with pytest.raises(CodecError, match="position"):
        encode(state)


def test_messages_that_leave_out_everything_cannot_fill_the_memory() -> None:
    sparse = pack({"markers": [{}] * 1_000_000})
    begin = time.process_time()
    with pytest.raises(CodecError, match="leave out too many values") as caught:
        messagepack_codec_for(MarkerArray).decode(sparse)
    assert caught.value.field == "markers"
    assert time.process_time() - begin < 5
    assert (
        len(messagepack_codec_for(MarkerArray).decode(pack({"markers": [{}] * 2_000})).markers)
        == 2_000
    )


def test_a_long_list_of_full_messages_is_decoded() -> None:
    codec = messagepack_codec_for(MarkerArray)
    full = MarkerArray(markers=[Marker()] * 20_000)
    assert codec.decode(codec.encode(full)) == full
