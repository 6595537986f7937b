from __future__ import annotations

import math
from typing import Any

import pytest

from zbot.interfaces import get_message, get_service
from zbot.interfaces.plain_value import json_value
from zbot.web.rosbridge.client_message import RosbridgeError
from zbot.web.rosbridge.json_message import message_from_json

from builtin_interfaces.msg import Time
from std_msgs.msg import Header

NOW = Time(sec=5, nanosec=6)


def read(name: str, value: Any) -> Any:
    return message_from_json(get_message(name), value, lambda: NOW)


def test_missing_fields_get_their_defaults() -> None:
    twist = read("geometry_msgs/msg/Twist", {"linear": {"x": 1}})
    assert (twist.linear.x, twist.linear.y, twist.angular.z) == (1.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("sensor_msgs/msg/LaserScan", {"ranges": [1.0, 2.5], "angle_min": -1.0}),
        ("sensor_msgs/msg/Image", {"data": "AAEC/w==", "height": 1, "encoding": "mono8"}),
        ("std_msgs/msg/ByteMultiArray", {"data": "AAEC"}),
        ("nav_msgs/msg/Odometry", {"pose": {"covariance": [0.5] * 36}}),
        ("std_msgs/msg/Int64", {"data": -(2**63)}),
        ("std_msgs/msg/UInt64", {"data": 2**64 - 1}),
        ("std_msgs/msg/Byte", {"data": 200}),
        ("std_msgs/msg/String", {"data": "Grüße \U0001f916"}),
        ("visualization_msgs/msg/MarkerArray", {"markers": [{"id": 3}, {"text": "a"}]}),
    ],
)
def test_what_is_read_is_written_again(name: str, value: Any) -> None:
    written = json_value(read(name, value))
    assert written == json_value(read(name, written))
    assert all(has_part(written[key], part_value) for key, part_value in value.items())


def has_part(whole: Any, part: Any) -> bool:
    if isinstance(part, dict):
        return all(has_part(whole[key], part_value) for key, part_value in part.items())
    if isinstance(part, list):
        return len(whole) == len(part) and all(map(has_part, whole, part))
    return bool(whole == part)


def test_octets_are_base64_or_numbers() -> None:
    assert bytes(read("sensor_msgs/msg/Image", {"data": [0, 1, 255]}).data) == b"\x00\x01\xff"
    assert bytes(read("sensor_msgs/msg/Image", {"data": "AAH/"}).data) == b"\x00\x01\xff"


def test_null_is_nan_for_floats_only() -> None:
    assert math.isnan(read("std_msgs/msg/Float64", {"data": None}).data)
    assert math.isnan(read("sensor_msgs/msg/LaserScan", {"ranges": [1, None]}).ranges[1])
    with pytest.raises(RosbridgeError, match=r"data must be an int .*, not nothing"):
        read("std_msgs/msg/Int32", {"data": None})


def test_a_header_without_stamp_gets_the_time() -> None:
    name = "geometry_msgs/msg/PoseStamped"
    assert read(name, {}).header.stamp == NOW
    assert read(name, {"header": {"frame_id": "map"}}).header == Header(stamp=NOW, frame_id="map")
    assert read(name, {"header": {"stamp": "now"}}).header.stamp == NOW
    stamped = read(name, {"header": {"stamp": {"sec": 1, "nanosec": 2}}})
    assert stamped.header.stamp == Time(sec=1, nanosec=2)
    old = read(name, {"header": {"stamp": {"secs": 1, "nsecs": 2}}})
    assert old.header.stamp == Time(sec=1, nanosec=2)


def test_a_list_has_the_first_fields() -> None:
    request: Any = get_service("example_interfaces/srv/AddTwoInts").Request  # type: ignore[attr-defined]
    assert message_from_json(request, [1, 2], lambda: NOW) == request(a=1, b=2)
    with pytest.raises(RosbridgeError, match="has 2 fields, not 3"):
        message_from_json(request, [1, 2, 3], lambda: NOW)


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        (
            "std_msgs/msg/String",
            "hello",
            "Value 'hello' is expected to be a dictionary but is a str",
        ),
        ("std_msgs/msg/String", {"data": 5}, "data must be a str, not 5"),
        ("std_msgs/msg/String", {"dat": ""}, "no attribute 'dat'; did you mean 'data'"),
        ("std_msgs/msg/Bool", {"data": 1}, "data must be a bool, not 1"),
        ("std_msgs/msg/Int8", {"data": 128}, "data must be an int from -128 to 127, not 128"),
        ("std_msgs/msg/Int8", {"data": 1.5}, "data must be an int .*, not 1.5"),
        ("std_msgs/msg/Int8", {"data": True}, "data must be an int .*, not 'true'"),
        (
            "std_msgs/msg/Float32",
            {"data": 1e39},
            r"data must be a float within float32's range, not 1e\+39",
        ),
        ("std_msgs/msg/Float64", {"data": 10**400}, "data must be a float, not 1000"),
        ("std_msgs/msg/Byte", {"data": 256}, "data must be an int from 0 to 255, not 256"),
        ("sensor_msgs/msg/Image", {"data": "%"}, "data must be base64 or a list"),
        (
            "sensor_msgs/msg/Image",
            {"data": [256]},
            r"data\[0\] must be an int from 0 to 255, not 256",
        ),
        ("sensor_msgs/msg/LaserScan", {"ranges": {"0": 1}}, "ranges must be a list"),
        (
            "nav_msgs/msg/Odometry",
            {"pose": {"covariance": [1]}},
            "pose.covariance must be a list of 36 values",
        ),
        (
            "geometry_msgs/msg/Twist",
            {"linear": None},
            "Value 'None' is expected to be a dictionary",
        ),
        ("nav_msgs/msg/Path", {"poses": [{"pose": 5}]}, r"write pose: \{position: "),
    ],
)
def test_a_value_of_another_type_is_named(name: str, value: Any, reason: str) -> None:
    with pytest.raises(RosbridgeError, match=reason):
        read(name, value)
