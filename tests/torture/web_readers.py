"""Readers of what web programs send: messages of the rosbridge protocol."""

from __future__ import annotations

import asyncio
import json
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.reader import Reader
from zbot.errors import ZbotError
from zbot.interfaces import get_message
from zbot.interfaces.plain_value import json_value
from zbot.observer.errors import ViewerError
from zbot.observer.serving.address import origin_of
from zbot.observer.serving.client_budget import OverBudgetError
from zbot.web.foxglove.connection import Connection, Streams
from zbot.web.foxglove.frame import read_frame, text_frame
from zbot.web.foxglove.guard import Guard
from zbot.web.foxglove.publishing import client_message
from zbot.web.page.layout import LayoutError, read_layout
from zbot.web.panels.sensors import sensor_message
from zbot.web.rosbridge.bridge import full_type
from zbot.web.rosbridge.client_message import Fragments, RosbridgeError, read_message
from zbot.web.rosbridge.frame import cbor, cbor_value, frames
from zbot.web.rosbridge.json_message import message_from_json
from zbot.web.rosbridge.rosapi import parameter_from_json
from zbot.wire.messagepack.codec import messagepack_codec_for

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Twist

_TYPES = (
    "geometry_msgs/msg/PoseStamped",
    "nav_msgs/msg/Odometry",
    "rcl_interfaces/msg/ParameterEvent",
    "sensor_msgs/msg/Image",
    "sensor_msgs/msg/LaserScan",
    "std_msgs/msg/ByteMultiArray",
    "std_msgs/msg/String",
    "visualization_msgs/msg/MarkerArray",
)


def _text(data: bytes) -> str:
    return data.decode(errors="replace")  # a websocket's text is valid UTF-8


def _client_message(data: bytes) -> None:
    message = read_message(_text(data))
    if message.op == "fragment":
        Fragments().add(message)
        return
    message.number("throttle_rate", 0)
    message.flag("latch")
    message_type: Any = _message_type(message.word("type", "std_msgs/String"))
    found = message_from_json(message_type, message.get("msg"), Time)
    frames({"op": "publish", "msg": json_value(found)}, fragment_size=100)
    cbor(cbor_value(found))
    assert messagepack_codec_for(message_type).encode(found) is not None


def _sensor_reading(data: bytes) -> None:
    try:
        reading = json.loads(_text(data))
    except (ValueError, RecursionError):
        return  # NiceGUI has checked the JSON
    stamp = Time()
    for message in (
        *(sensor_message.picture(reading, stamp, "a") or ()),
        sensor_message.imu(reading, stamp, "a"),
        sensor_message.level(reading),
        sensor_message.fix(reading, stamp, "a"),
    ):
        if message is not None:
            assert messagepack_codec_for(type(message)).encode(message) is not None


def _message_type(name: str) -> Any:
    try:
        return get_message(full_type("msg", name))
    except LookupError as error:
        # The server answers this with an error of its own, as the type is not known here.
        raise RosbridgeError(str(error)) from error


def _seeds() -> tuple[bytes, ...]:
    texts = [
        json.dumps(
            {"op": "publish", "id": "a", "type": name, "msg": json_value(get_message(name)())}
        )
        for name in _TYPES
    ]
    texts += [
        '{"op": "publish", "type": "sensor_msgs/LaserScan", "msg": {"ranges": [1, null, 2.5e3]}}',
        '{"op": "publish", "type": "sensor_msgs/Image", "msg": {"data": "AAEC", "height": 1}}',
        '{"op": "publish", "type": "std_msgs/Header", "msg": {"stamp": {"secs": 1, "nsecs": 2}}}',
        '{"op": "fragment", "id": 1, "num": 0, "total": 2, "data": "{"}',
        '{"op": "subscribe", "topic": "/a", "throttle_rate": 1e999, "latch": null}',
    ]
    return tuple(text.encode() for text in texts)


def _no_client() -> Any:
    raise NotImplementedError  # nothing connects


def _foxglove_request(data: bytes) -> None:
    guard = Guard("127.0.0.1", ("127.0.0.1", 1), "a", publishing=_no_client)
    guard.refusal(data)
    guard.without_token(data)


class _NoWriter:
    def write(self, _data: bytes) -> None:
        """Ignore the data."""

    async def drain(self) -> None:
        """Do nothing."""


class _NoPublishing:
    def advertise(self, _channel: Any) -> None:
        raise ViewerError("no")

    def unadvertise(self, number: Any) -> None:
        hash(number)

    def publish(self, number: int, data: bytes) -> None:
        assert isinstance(number + len(data), int)


def _connection(data: bytes) -> None:
    async def run() -> None:
        reader = asyncio.StreamReader()
        reader.feed_data(data)
        reader.feed_eof()
        streams: Any = Streams(reader, _NoWriter())  # type: ignore[arg-type]
        publishing: Any = _NoPublishing()
        with ThreadPoolExecutor(1) as threads:
            await Connection(streams, streams, publishing, threads, threads)._from_client()

    asyncio.run(run())


_OPERATIONS: tuple[dict[str, Any], ...] = (
    {"op": "advertise", "channels": [{"id": 1, "topic": "/a"}, 5]},
    {"op": "unadvertise", "channelIds": [1]},
    {"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 2}]},
    {"op": "unsubscribe", "subscriptionIds": [1, "a"]},
    {"op": "getParameters", "parameterNames": [], "id": "all"},
)


def _frame(data: bytes) -> None:
    async def read() -> None:
        reader = asyncio.StreamReader()
        reader.feed_data(data)
        reader.feed_eof()
        (await read_frame(reader, 1000)).content()

    asyncio.run(read())


WEB_READERS = (
    Reader(
        "layout",
        ("zbot.web.page.layout",),
        lambda data: read_layout(_text(data), ("graph", "plot")).file_text(),
        (LayoutError,),
        (
            b'{"title": "Lesson", "rows": [["graph", "plot?curve=%2Fpose.x&a"], ["graph"]]}',
            b'{"rows": [["plot?%ff=\\ud800"]]}',
        ),
    ),
    Reader(
        "rosbridge_message",
        (
            "zbot.web.rosbridge.client_message",
            "zbot.interfaces.message_reader",
            "zbot.web.rosbridge.json_message",
            "zbot.web.rosbridge.bridge",
        ),
        _client_message,
        (RosbridgeError,),
        _seeds(),
    ),
    Reader(
        "rosapi_parameter",
        ("zbot.web.rosbridge.rosapi",),
        lambda data: parameter_from_json("a", _text(data)),
        (RosbridgeError,),
        (b"5", b"1.5", b'"a"', b"[1, 2.5]", b'["a", null]', b"null", b"9223372036854775808"),
    ),
    Reader(
        "foxglove_request",
        ("zbot.web.foxglove.guard",),
        _foxglove_request,
        (),
        (b"GET /?token=a HTTP/1.1\r\nHost: a:1\r\nUpgrade: websocket\r\nOrigin: null\r\n\r\n",),
    ),
    Reader(
        "foxglove_frame",
        ("zbot.web.foxglove.frame",),
        _frame,
        (OverBudgetError, asyncio.IncompleteReadError),
        (b"\x81\x85\1\2\3\4hello", b"\x82\xfe\0\x7e\1\2\3\4" + bytes(126), text_frame({"op": "a"})),
    ),
    Reader(
        "foxglove_client",
        ("zbot.web.foxglove.connection",),
        _connection,
        (OverBudgetError,),
        (
            *(text_frame(fields, is_masked=True) for fields in _OPERATIONS),
            b"\x82\x87\0\0\0\0\1\0\0\0\0{}",
            b"\x82\x8d\0\0\0\0\2\0\0\0\0\0\0\0\0\3\0\0\0",
        ),
        # An input can be 9,000 messages that are refused one after the other, with a pause of 1 ms
        # after each. This takes 10 s, and 2 s of a processor.
        limit_s=4.0,
    ),
    Reader(
        "foxglove_message",
        ("zbot.web.foxglove.publishing",),
        lambda data: client_message(data, Twist, "json"),
        (ZbotError,),
        (b'{"linear": {"x": 1.5}}', b'{"linear": {"x": null}}'),
    ),
    Reader(
        "sensor_reading",
        ("zbot.web.panels.sensors.sensor_message",),
        _sensor_reading,
        (),
        (
            b'["/9j/AA==", 640, 480]',
            b"[0.5]",
            b"[]",
            b"[46.5, 6.6, null, 10, null]",
            b"[0, 90, -45.5, 1, 2, 9.81, null, null, null, 1e300, 2, 3]",
        ),
    ),
    Reader(
        "web_origin",
        ("zbot.observer.serving.address",),
        lambda data: origin_of(_text(data)),
        (ViewerError,),
        (b"http://localhost:8000", b"https://[::1]:443/a", b"http://a:99999"),
    ),
)
