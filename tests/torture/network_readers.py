"""Readers of bytes from the network: messages, tokens, answers and documents."""

from __future__ import annotations

import functools
import json
from types import SimpleNamespace
from typing import Any

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.reader import Reader, json_bytes
from zbot.errors import InvalidNameError, WrongValueError
from zbot.graph.endpoint_info import TypeHash
from zbot.graph.snapshot import Snapshot, full_names
from zbot.interfaces import get_interface, get_message, type_description, type_name
from zbot.interfaces.definition_limits import check_limits
from zbot.interfaces.errors import (
    InterfaceSyntaxError,
    UnknownInterfaceError,
    UnknownPackageError,
)
from zbot.interfaces.plain_value import json_value
from zbot.interfaces.remote_definition import hash_among, specs_from, specs_from_sources
from zbot.launch.control.control_server import read_request
from zbot.launch.errors import LaunchControlError
from zbot.libraries.image_array import CvBridge, CvBridgeError
from zbot.libraries.point_cloud import read_points
from zbot.names import validate_full_topic_name
from zbot.observer.image_encoder import ImageError, encode_jpeg, media_type
from zbot.observer.value_text import brief
from zbot.parameters.parameter import UnknownParameterTypeError
from zbot.remote.parameters import RemoteParameters
from zbot.text.json_reader import JsonError, read_json, read_json_object
from zbot.transport.admin_query import process_of, router_facts
from zbot.web.page.topic_picture import points_of, ring
from zbot.web.panels.parameters.described_parameter import load
from zbot.web.server.page_discovery import address_in
from zbot.wire import attachment
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.embedded.micropython_module import micropython_module
from zbot.wire.error_reply import unpack_error
from zbot.wire.errors import CodecError, TokenError
from zbot.wire.keys import encoded_type, parse_key
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.messagepack.packing import UnreadableError, pack, unpack
from zbot.wire.rmw_zenoh import ROS2
from zbot.wire.tokens import parse_token
from zbot.wire.transcoder.transcoder import to_cdr, to_messagepack

from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry, Path
from rcl_interfaces.msg import Log, ParameterEvent
from rcl_interfaces.srv import DescribeParameters, GetParameters
from sensor_msgs.msg import CompressedImage, Image, JointState, LaserScan, PointCloud2, PointField
from std_msgs.msg import ByteMultiArray, String
from visualization_msgs.msg import Marker, MarkerArray

_POSE_STAMPED: Any = get_message("geometry_msgs/msg/PoseStamped")
_TYPES: tuple[Any, ...] = (
    String(data="hello"),
    Twist(),
    Odometry(),
    Path(poses=[_POSE_STAMPED()]),
    MarkerArray(markers=[Marker(text="a"), Marker()]),
    Log(level=40, name="talker", msg="late", file="a.py", line=5),
    ParameterEvent(),
    LaserScan(ranges=[0.5] * 40, range_max=9.0, angle_increment=0.1),
    PointCloud2(width=2, height=1, point_step=4, data=bytes(8)),
    ByteMultiArray(data=[b"a", b"b"]),
    JointState(name=[f"joint_{number}" for number in range(30)]),
    get_message("std_msgs/msg/UInt8MultiArray")(data=bytes(5000)),
    get_message("action_msgs/msg/GoalStatusArray")(),
)
_UNKNOWN = (InterfaceSyntaxError, UnknownInterfaceError, UnknownPackageError)
_BOX = "box_msgs/msg/Box"


def _text(data: bytes) -> str:
    return data.decode(errors="replace")  # Zenoh's keys are valid UTF-8


def _typed(codec_of: Any) -> Any:
    def call(data: bytes) -> None:
        message_type = type(_TYPES[data[0] % len(_TYPES)]) if data else String
        message = codec_of(message_type).decode(data[1:])
        brief(message)
        json.dumps(json_value(message))

    return call


def _converted(converter: Any) -> Any:
    def call(data: bytes) -> None:
        message_type = type(_TYPES[data[0] % len(_TYPES)]) if data else String
        assert converter(message_type)(data[1:])

    return call


@functools.cache
def _board_module() -> dict[str, Any]:
    """Return the module for MicroPython with the types above, as CPython runs it."""
    module: dict[str, Any] = {}
    names = dict.fromkeys(type_name(type(message)) for message in _TYPES)
    exec(micropython_module(names), module)
    classes = {cls.TYPE_NAME: cls for cls in module.values() if hasattr(cls, "TYPE_NAME")}
    return module | classes


def _on_board(data: bytes) -> None:
    """Read a message as a microcontroller does."""
    module = _board_module()
    message_type = type(_TYPES[data[0] % len(_TYPES)]) if data else String
    try:
        module["read"](module[type_name(message_type)], data[1:])
    except module["CdrError"] as error:
        raise CodecError("decode", "", "", str(error)) from error


def _typed_seeds(codec_of: Any) -> tuple[bytes, ...]:
    return tuple(
        bytes((index,)) + codec_of(type(message)).encode(message)
        for index, message in enumerate(_TYPES)
    )


def _decoded(message_type: Any, data: bytes) -> Any:
    return messagepack_codec_for(message_type).decode(data)


def _encoded(message: Any) -> bytes:
    encode: Any = messagepack_codec_for(type(message)).encode
    octets: bytes = encode(message)
    return octets


def _token(data: bytes) -> None:
    token: Any = parse_token(_text(data))
    graph = Snapshot((token,))
    full_names(graph.nodes)
    assert [graph.topics(), graph.services(), graph.actions()]
    assert token.gid
    if graph.endpoints:
        TypeHash.parse(graph.endpoints[0].type_hash)


def _ros2_token(data: bytes) -> None:
    token: Any = ROS2.parse_token(_text(data))
    assert len(token.gid) == 16
    assert token == ROS2.parse_token(token.key)
    ROS2.with_key(token)


def _names(data: bytes) -> None:
    key = _text(data)
    parse_key(key)
    encoded_type(key)
    str(TypeHash.parse(key))
    validate_full_topic_name(key)


def _sources(data: bytes) -> None:
    parts = _text(data).split("=====")
    texts = dict(zip(parts[::2], parts[1::2], strict=False))
    specs = specs_from_sources(_BOX, texts)
    check_limits(specs)
    hash_among(_BOX, specs)


def _description(data: bytes) -> None:
    specs = specs_from(read_json_object(data))
    check_limits(specs)


def _description_response(data: bytes) -> None:
    from zbot.node.definition_request import _from_description, _from_texts  # noqa: PLC0415

    answer = _decoded(
        get_interface("type_description_interfaces/srv/GetTypeDescription_Response"), data
    )
    for read in (_from_texts, _from_description):
        check_limits(read(answer, _BOX))


def _parameters(data: bytes) -> None:
    values, _, descriptors = data.partition(b"=====")
    got = _decoded(GetParameters.Response, values).values
    described = _decoded(DescribeParameters.Response, descriptors).descriptors
    names = [f"a{index}" for index in range(len(got))]
    listed = SimpleNamespace(names=names)
    answers = SimpleNamespace(result=listed, values=got, descriptors=described)
    calls: Any = SimpleNamespace(call=lambda *_: answers)
    for parameter in load(RemoteParameters(calls), "/node"):
        assert parameter.text is not None


def _image(data: bytes) -> None:
    message = _decoded(Image, data)
    try:
        CvBridge().imgmsg_to_cv2(message)
    except CvBridgeError:
        encode_jpeg(message)


def _cloud(data: bytes) -> None:
    read_points(_decoded(PointCloud2, data))


def _scan(data: bytes) -> None:
    _, reach = points_of(_decoded(LaserScan, data))
    ring(reach)


def _box_texts() -> bytes:
    texts = {
        _BOX: "Lid lid\nfloat64[3] size 1\nstring<=5 name 'a' # b\n",
        "box_msgs/msg/Lid": "bool x\n",
    }
    return "=====".join(part for pair in texts.items() for part in pair).encode()


def _response(name: str) -> bytes:
    from zbot.node.type_description import _describe  # noqa: PLC0415

    srv: Any = get_interface("type_description_interfaces/srv/GetTypeDescription")
    return _encoded(
        _describe(srv.Request(type_name=name, include_type_sources=True), srv.Response())
    )


_FACTS = {"host": "desk", "pid": 7, "started": 9, "version": "1", "command": "run"}
_ANSWER = json_bytes(
    {"sessions": [{"peer": "a1", "whatami": "peer"}], "metadata": {"zbot": _FACTS}, "locators": []}
)
_ROS2_TOKEN = (
    b"@ros2_lv/5/a1b2/0/7/MP/%/%robots/talker/%chatter/std_msgs::msg::dds_::String_/RIHS01_"
    + b"a" * 64
    + b"/2:1:,5:0,100000000:,:,,"
)
_TOKEN = (
    b"@zbot/5/a1b2/0/7/MP/%/%robots/talker/%chatter/std_msgs%msg%String/RIHS01_"
    + b"a" * 64
    + b"/::,10:,:,:,,"
)

NETWORK_READERS = (
    Reader(
        "launch_request",
        ("zbot.launch.control.control_server",),
        read_request,
        (LaunchControlError,),
        (b'{"token": "a", "op": "stop", "label": "talker-1"}', b'{"op": []}', b"GET / HTTP/1.1"),
    ),
    Reader(
        "json",
        ("zbot.text.json_reader",),
        read_json,
        (JsonError,),
        (
            _ANSWER,
            b'[1, -2.5e3, "\\u00e9\\ud83e\\udd16", null, true, {}]',
            b"[" * 9000,
            b"Infinity",
        ),
    ),
    Reader(
        "admin_space_router",
        ("zbot.transport.admin_query",),
        router_facts,
        (JsonError,),
        (_ANSWER,),
    ),
    Reader(
        "admin_space_process",
        ("zbot.transport.admin_query",),
        lambda data: process_of("a1", data),
        (),
        (_ANSWER, b'{"metadata": {"zbot": {"pid": Infinity}}}'),
    ),
    Reader(
        "liveliness_token",
        ("zbot.wire.tokens", "zbot.wire.qos"),
        _token,
        (TokenError,),
        (_TOKEN, b"@zbot/5/a1b2/0/0/NN/%/%robots/talker", _TOKEN.replace(b"MP", b"SS")),
    ),
    Reader(
        "ros2_token",
        ("zbot.wire.rmw_zenoh", "zbot.wire.tokens", "zbot.wire.qos"),
        _ros2_token,
        (TokenError,),
        (_ROS2_TOKEN, b"@ros2_lv/5/a1b2/0/0/NN/%/%robots/talker", _ROS2_TOKEN + b"/backends:cpu:"),
    ),
    Reader(
        "key",
        ("zbot.wire.keys", "zbot.names", "zbot.graph.endpoint_info"),
        _names,
        (InvalidNameError,),
        (
            b"5/chatter",
            b"/robots/a_1",
            b"RIHS01_" + b"a" * 64,
            b"zbot;std_msgs/msg/String",
            b"/" + b"a/" * 90 + b"b",
        ),
    ),
    Reader(
        "messagepack",
        ("zbot.wire.messagepack.packing",),
        unpack,
        (UnreadableError,),
        (
            pack({"a": [1, 2.5, "b", b"c", None, True, {"d": [0] * 2000}]}),
            b"\xdd\xff\xff\xff\xff" * 9,
            b"\x91" * 9000,
        ),
    ),
    Reader(
        "message",
        (
            "zbot.wire.messagepack.codec",
            "zbot.wire.messagepack.decoder_source",
            "zbot.wire.messagepack.value_reader",
            "zbot.wire.messagepack.walker",
            "zbot.wire.messagepack.walker",
            "zbot.interfaces.array_value",
            "zbot.interfaces.field_check",
        ),
        _typed(messagepack_codec_for),
        (CodecError,),
        _typed_seeds(messagepack_codec_for),
    ),
    Reader(
        "cdr_message",
        ("zbot.wire.cdr.codec", "zbot.wire.cdr.decoder_source", "zbot.wire.cdr.values"),
        _typed(cdr_codec_for),
        (CodecError,),
        _typed_seeds(cdr_codec_for),
    ),
    Reader(
        "cdr_on_a_board",
        ("zbot.wire.embedded.cdr_module",),
        _on_board,
        (CodecError,),
        _typed_seeds(cdr_codec_for),
    ),
    Reader(
        "cdr_to_messagepack",
        ("zbot.wire.transcoder.transcoder", "zbot.wire.transcoder.values"),
        _converted(to_messagepack),
        (CodecError,),
        _typed_seeds(cdr_codec_for),
    ),
    Reader(
        "messagepack_to_cdr",
        ("zbot.wire.transcoder.transcoder", "zbot.wire.transcoder.values"),
        _converted(to_cdr),
        (CodecError,),
        _typed_seeds(messagepack_codec_for),
    ),
    Reader(
        "attachment",
        ("zbot.wire.attachment",),
        attachment.unpack,
        (),
        (attachment.pack(5, 6, bytes(16)), b""),
    ),
    Reader(
        "error_reply",
        ("zbot.wire.error_reply",),
        unpack_error,
        (),
        (pack({"error": "a", "message": "b"}), b"plain text"),
    ),
    Reader(
        "type_sources",
        ("zbot.interfaces.remote_definition", "zbot.interfaces.definition_limits"),
        _sources,
        _UNKNOWN,
        (_box_texts(), b"box_msgs/msg/Box=====Box b\n"),
    ),
    Reader(
        "type_description",
        ("zbot.interfaces.remote_definition",),
        _description,
        (*_UNKNOWN, JsonError),
        (
            json_bytes(type_description("geometry_msgs/msg/PoseStamped")),
            json_bytes(type_description("std_srvs/srv/SetBool")),
        ),
    ),
    Reader(
        "type_description_response",
        ("zbot.node.definition_request",),
        _description_response,
        (*_UNKNOWN, CodecError),
        (_response("geometry_msgs/msg/Pose"), _response("std_msgs/msg/String")),
    ),
    Reader(
        "parameter_answers",
        (
            "zbot.web.panels.parameters.described_parameter",
            "zbot.remote.parameters",
            "zbot.parameters.parameter",
        ),
        _parameters,
        (CodecError, WrongValueError, UnknownParameterTypeError),
        (
            pack({"values": [{"type": 2, "integer_value": 5}]})
            + b"====="
            + pack(
                {
                    "descriptors": [
                        {"name": "a0", "integer_range": [{"from_value": 1, "to_value": 9}]}
                    ]
                }
            ),
            pack(
                {
                    "values": [
                        {"type": 9, "string_array_value": ["a"]},
                        {"type": 5, "byte_array_value": [1]},
                    ]
                }
            )
            + b"====="
            + pack({"descriptors": [{}, {}]}),
        ),
    ),
    Reader(
        "image",
        ("zbot.libraries.image_array", "zbot.observer.image_encoder"),
        _image,
        (CodecError, ImageError, CvBridgeError),
        (
            _encoded(Image(width=2, height=2, encoding="rgb8", step=6, data=bytes(12))),
            _encoded(Image(width=2, height=1, encoding="32FC1", step=8, data=bytes(8))),
        ),
    ),
    Reader(
        "compressed_image",
        ("zbot.observer.image_encoder",),
        lambda data: media_type(bytes(_decoded(CompressedImage, data).data)),
        (CodecError, ImageError),
        (_encoded(CompressedImage(format="jpeg", data=b"\xff\xd8\xff")),),
    ),
    Reader(
        "laser_scan",
        ("zbot.web.page.topic_picture",),
        _scan,
        (CodecError,),
        (_encoded(LaserScan(ranges=[0.5, 2.0], range_max=9.0, angle_increment=0.1)),),
    ),
    Reader(
        "point_cloud",
        ("zbot.libraries.point_cloud",),
        _cloud,
        (CodecError, ValueError, AssertionError),
        (
            _encoded(
                PointCloud2(
                    width=2,
                    height=1,
                    point_step=4,
                    row_step=8,
                    data=bytes(8),
                    fields=[PointField(name="x", datatype=7, count=1)],
                )
            ),
        ),
    ),
    Reader(
        "page_announcement",
        ("zbot.web.server.page_discovery",),
        lambda data: address_in(_text(data)),
        (),
        (b'{"host": "desk", "address": "http://127.0.0.1:8080"}', b'{"host": 5}'),
    ),
)
