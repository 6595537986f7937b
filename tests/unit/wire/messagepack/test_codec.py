from __future__ import annotations

import math
from array import array
from dataclasses import dataclass
from typing import Annotated, Any

import msgpack  # type: ignore[import-untyped]
import pytest

import zbot  # noqa: F401 - makes the messages importable
from tests.conftest import in_threads
from tests.unit.wire.messagepack.coded import decode, encode, packb
from tests.unit.wire.picky import Picky
from zbot.errors import ExternalShutdownException
from zbot.interfaces import get_interface, get_message
from zbot.interfaces.errors import NotAMessageTypeError
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for

from geometry_msgs.msg import PoseStamped, Twist, Vector3
from nav_msgs.msg import Odometry, Path
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import (
    Bool,
    Byte,
    ByteMultiArray,
    Empty,
    Float32,
    Int16MultiArray,
    String,
    UInt8MultiArray,
)
from unique_identifier_msgs.msg import UUID


@pytest.mark.parametrize(
    ("message", "value"),
    [
        (String(data="hé"), {"data": "hé"}),
        (Empty(), {}),
        (
            Twist(linear=Vector3(x=0.5)),
            {"linear": {"x": 0.5, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": 0.0}},
        ),
        (Bool(data=True), {"data": True}),
        (Byte(data=b"\x07"), {"data": 7}),
        (
            ByteMultiArray(data=[b"\x01", b"\xff"]),
            {"layout": {"dim": [], "data_offset": 0}, "data": b"\1\xff"},
        ),
        (
            UInt8MultiArray(data=b"\1\2"),
            {"layout": {"dim": [], "data_offset": 0}, "data": b"\1\2"},
        ),
        (
            Int16MultiArray(data=[1, -2]),
            {
                "layout": {"dim": [], "data_offset": 0},
                "data": msgpack.ExtType(ord("h"), b"\x01\x00\xfe\xff"),
            },
        ),
        (
            UUID(uuid=range(16)),
            {"uuid": bytes(range(16))},
        ),
    ],
)
def test_bytes_are_those_of_plain_msgpack(message: Any, value: Any) -> None:
    assert encode(message) == packb(value)
    assert decode(type(message), value) == message


def test_the_documented_example_has_the_documented_bytes() -> None:
    assert encode(String(data="hi")) == b"\x81\xa4data\xa2hi"


def test_extension_codes_are_array_typecodes() -> None:
    for name, typecode in [
        ("Int8", "b"),
        ("Int16", "h"),
        ("UInt16", "H"),
        ("Int32", "i"),
        ("UInt32", "I"),
        ("Int64", "q"),
        ("UInt64", "Q"),
        ("Float32", "f"),
        ("Float64", "d"),
    ]:
        message_class: Any = get_message(f"std_msgs/msg/{name}MultiArray")
        message = message_class(data=[1, 2, 3])
        extension = msgpack.unpackb(encode(message))["data"]
        assert (extension.code, len(extension.data)) == (
            ord(typecode),
            3 * array(typecode).itemsize,
        )
        assert decode(type(message), encode(message)).data == array(typecode, [1, 2, 3])


def test_a_nested_numeric_array_is_an_extension_too() -> None:
    odometry = Odometry()
    odometry.pose.covariance[35] = 2.5
    value = msgpack.unpackb(encode(odometry))
    assert value["pose"]["covariance"].code == ord("d")
    assert decode(Odometry, encode(odometry)) == odometry


def test_a_map_with_many_fields_keeps_its_order() -> None:
    marker_class: Any = get_message("visualization_msgs/msg/Marker")
    marker = marker_class(id=5, text="here")
    value = msgpack.unpackb(encode(marker))
    assert list(value) == list(type(marker).get_fields_and_field_types())
    assert decode(type(marker), encode(marker)) == marker


def test_nan_round_trips() -> None:
    assert math.isnan(decode(Float32, encode(Float32(data=math.nan))).data)


def test_a_large_image_in_any_buffer_type_round_trips() -> None:
    image = Image(height=1000, width=300, data=array("B", bytes(range(250)) * 1200))
    data = encode(image)
    for held in (data, bytearray(data), memoryview(data)):
        received = messagepack_codec_for(Image).decode(held)
        assert received == image
        assert type(received.data) is array
    assert msgpack.unpackb(data)["data"] == image.data.tobytes()


def test_large_numeric_arrays_round_trip() -> None:
    scan = LaserScan(ranges=array("f", range(50_000)), intensities=array("f", range(40_000)))
    scan.header.frame_id = "laser"
    assert decode(LaserScan, encode(scan)) == scan


def test_long_lists_round_trip() -> None:
    path = Path(poses=[PoseStamped() for _ in range(1500)])
    assert decode(Path, encode(path)) == path


def test_received_arrays_can_be_changed() -> None:
    odometry = decode(Odometry, encode(Odometry()))
    odometry.pose.covariance[0] = 1.0
    image = decode(Image, encode(Image(data=b"\1\2")))
    image.data[0] = 9
    assert (odometry.pose.covariance[0], list(image.data)) == (1.0, [9, 2])


@dataclass
class Reading:
    name: str
    count: int
    ratio: float
    blob: bytes
    values: list[float]
    small: Annotated[int, "uint8"] = 3
    where: Annotated[Any, "geometry_msgs/Twist"] = None


def test_dataclasses_are_messages() -> None:
    reading = Reading("a", 2, 0.5, b"\1\2", [1.0, 2.0], 4, Twist())
    received = decode(Reading, encode(reading))
    assert received == reading
    assert (type(received.blob), type(received.values)) == (bytes, list)


def test_a_dataclass_with_wrong_values_is_not_sent() -> None:
    with pytest.raises(CodecError, match="'small'"):
        encode(Reading("a", 2, 0.5, b"", [], 256, Twist()))


def test_an_error_in_a_dataclass_constructor_is_a_codec_error() -> None:
    with pytest.raises(CodecError, match="KeyError: 'thirteen'"):
        decode(Picky, {"value": 13})


def test_a_signal_during_decoding_is_not_a_codec_error() -> None:
    with pytest.raises(ExternalShutdownException):
        decode(Picky, {"value": 15})


def test_the_encoding_names_the_type() -> None:
    assert messagepack_codec_for(String).encoding == "application/msgpack;std_msgs/msg/String"


def test_a_codec_is_made_once() -> None:
    assert messagepack_codec_for(String) is messagepack_codec_for(String)


def test_a_codec_has_its_generated_source() -> None:
    assert "def encode(message):" in messagepack_codec_for(Twist).source
    assert "FLOAT32_MAX" in messagepack_codec_for(Float32).source


@pytest.mark.parametrize("wrong", [int, 5, get_interface("std_srvs/srv/Trigger")])
def test_only_messages_have_codecs(wrong: Any) -> None:
    with pytest.raises(NotAMessageTypeError):
        messagepack_codec_for(wrong)


def test_threads_share_codecs() -> None:
    failures: list[str] = []

    def work(number: int) -> None:
        for _ in range(300):
            message = String(data=str(number) * 50)
            if decode(String, encode(message)) != message:
                failures.append(message.data)

    in_threads(work, 4)
    assert not failures
