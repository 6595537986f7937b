"""Readers of what boards and brokers send."""

from __future__ import annotations

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.reader import Reader, file_with, text_of
from zbot.bridge.devices.errors import DeviceError, UnreadableError
from zbot.bridge.devices.message_maker import MessageMaker
from zbot.bridge.devices.mqtt.address import parse_address
from zbot.bridge.devices.mqtt.payload import read_payload
from zbot.bridge.devices.serial.line import LineReader
from zbot.bridge.devices.serial.line_buffer import LineBuffer
from zbot.bridge.devices.text_value import topic_name
from zbot.bridge.devices.topic_subscriptions import Wanted
from zbot.bridge.devices.topic_type import read_types, type_of_value
from zbot.names import validate_topic_name

from builtin_interfaces.msg import Time


def _lines(data: bytes) -> None:
    """Read lines as a board's loop does, with the messages of their values."""
    buffer, readers = LineBuffer(), (LineReader(topic="a"), LineReader(names=("x", "y")))
    for line in buffer.feed(data):
        for reader in readers:
            for name, value, kind in reader.read(line.decode(errors="replace")):
                text = topic_name(name)
                if text:
                    validate_topic_name(text)
                known = kind or (None if isinstance(value, dict) else type_of_value(value))
                if known is not None:
                    MessageMaker(known, Time).make(value)


def _payload(data: bytes) -> None:
    value = read_payload(data)
    kind = None if isinstance(value, dict) else type_of_value(value)
    if kind is not None:
        MessageMaker(kind, Time).make(value)


DEVICE_READERS = (
    Reader(
        "mqtt_payload",
        ("zbot.bridge.devices.mqtt.payload",),
        _payload,
        (UnreadableError,),
        (b"23.5 \xc2\xb0C", b"ON", b'{"ENERGY": {"Power": [1, 2]}}', b'"text"', b"[" * 5000),
    ),
    Reader(
        "mqtt_address",
        ("zbot.bridge.devices.mqtt.address",),
        lambda data: parse_address(text_of(data)),
        (DeviceError,),
        (b"mqtts://ana:a%40b@broker:8883", b"[::1]:1883", b"broker"),
    ),
    Reader(
        "serial_line",
        (
            "zbot.bridge.devices.serial.line",
            "zbot.bridge.devices.serial.line_buffer",
            "zbot.bridge.devices.text_value",
            "zbot.bridge.devices.message_maker",
        ),
        _lines,
        (UnreadableError,),
        (
            b"temperature: 23.5 C\r\nt:1,h:2\nstate: open\n",
            b'{"a": {"b": [1, 2.5, "c", null]}}\n',
            b'/imu sensor_msgs/msg/Imu {"angular_velocity": {"z": 0.5}}\n',
            b"/t std_msgs/msg/Float32MultiArray {data: [1, 2], layout: {dim: []}}\n",
            b"1, 2.5\n-7\nnan\n",
            b"a" * 5000 + b": 1\n" + b"a:1 " * 2000 + b"\n",
        ),
    ),
    Reader(
        "device_types",
        ("zbot.bridge.devices.topic_type",),
        lambda data: read_types(file_with("types.yaml", data)),
        (DeviceError,),
        (b"temperature: Float64\n/home/*: std_msgs/msg/Bool\n", b"a: sensor_msgs/Range.range\n"),
    ),
    Reader(
        "device_topics",
        ("zbot.bridge.devices.topic_subscriptions",),
        lambda data: Wanted.parse(text_of(data)),
        (DeviceError,),
        (b"/led:std_msgs/msg/Bool=cmnd/lamp/POWER", b"/robot/*"),
    ),
)
