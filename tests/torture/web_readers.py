"""Readers of what web programs send: messages of the rosbridge protocol."""

from __future__ import annotations

import json
from typing import Any

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.reader import Reader
from zbot.errors import ZbotError
from zbot.interfaces import get_message
from zbot.interfaces.plain_value import json_value
from zbot.observer.errors import ViewerError
from zbot.web.foxglove.guard import Guard
from zbot.web.foxglove.listener import client_message
from zbot.web.page_address import origin_of
from zbot.web.rosbridge.bridge import full_type
from zbot.web.rosbridge.cbor import cbor_value, encode
from zbot.web.rosbridge.client_message import Fragments, RosbridgeError, read_message
from zbot.web.rosbridge.frame import frames
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
    encode(cbor_value(found))
    assert messagepack_codec_for(message_type).encode(found) is not None


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


def _foxglove_request(data: bytes) -> None:
    guard = Guard("127.0.0.1", ("127.0.0.1", 1), "a")
    guard.refusal(data)
    guard.without_token(data)


WEB_READERS = (
    Reader(
        "rosbridge_message",
        (
            "zbot.web.rosbridge.client_message",
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
        "foxglove_message",
        ("zbot.web.foxglove.listener",),
        lambda data: client_message(data, Twist, "json"),
        (ZbotError, ValueError, TypeError),
        (b'{"linear": {"x": 1.5}}', b'{"linear": {"x": null}}'),
    ),
    Reader(
        "web_origin",
        ("zbot.web.page_address",),
        lambda data: origin_of(_text(data)),
        (ViewerError,),
        (b"http://localhost:8000", b"https://[::1]:443/a", b"http://a:99999"),
    ),
)
