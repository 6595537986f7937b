from __future__ import annotations

from random import Random
from typing import Any

import msgpack  # type: ignore[import-untyped]
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.unit.wire.random_message import message_of, random_message, shipped_messages
from zbot.interfaces import get_interface, get_message
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for

packb: Any = msgpack.packb


def test_every_shipped_type_round_trips_with_random_values() -> None:
    names = shipped_messages()
    assert len(names) > 300
    for name in names:
        message = message_of(name)
        codec = messagepack_codec_for(type(message))
        data = codec.encode(message)
        assert codec.decode(data) == message, name
        assert codec.encode(codec.decode(memoryview(data))) == data, name


def test_a_message_of_defaults_equals_an_empty_map() -> None:
    for name in shipped_messages():
        message_class = get_interface(name)
        assert messagepack_codec_for(message_class).decode(b"\x80") == message_class(), name


# Values of possible types for any field: most of the maps below are nearly valid.
FIELDS = ["data", "header", "stamp", "sec", "frame_id", "ranges", "name", "position", "pose", "x"]
FIELDS += ["covariance", "poses", "layout", "dim", "level", "values", "orientation"]
SUBJECTS = [
    messagepack_codec_for(get_message(name))
    for name in (
        "std_msgs/msg/String",
        "sensor_msgs/msg/Image",
        "sensor_msgs/msg/LaserScan",
        "sensor_msgs/msg/JointState",
        "nav_msgs/msg/Odometry",
        "nav_msgs/msg/Path",
        "diagnostic_msgs/msg/DiagnosticStatus",
        "std_msgs/msg/ByteMultiArray",
    )
]

scalars = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(min_value=-(2**63), max_value=2**64 - 1),
    st.floats(),
    st.text(max_size=8),
    st.binary(max_size=16),
    st.builds(msgpack.ExtType, st.sampled_from(list(b"bhdfQx\x01")), st.binary(max_size=16)),
)
values = st.recursive(
    scalars,
    lambda inner: st.one_of(
        st.lists(inner, max_size=4),
        st.dictionaries(st.sampled_from(FIELDS), inner, max_size=4),
    ),
    max_leaves=12,
)


def assert_message_or_codec_error(data: bytes) -> None:
    for codec in SUBJECTS:
        try:
            message = codec.decode(data)
        except CodecError:
            continue
        # An accepted message is valid: it can be encoded and decoded, and is equal after that.
        again = codec.encode(message)
        assert codec.encode(codec.decode(again)) == again


@given(st.binary(max_size=200))
def test_any_bytes_are_a_message_or_a_codec_error(data: bytes) -> None:
    assert_message_or_codec_error(data)


@given(values)
def test_any_value_is_a_message_or_a_codec_error(value: Any) -> None:
    assert_message_or_codec_error(packb(value))


@given(
    subject=st.sampled_from(SUBJECTS),
    seed=st.integers(min_value=0, max_value=1000),
    edits=st.lists(st.tuples(st.floats(0, 1), st.integers(0, 255)), min_size=1, max_size=4),
    cut=st.floats(0.5, 1.5),
)
def test_damaged_messages_are_messages_or_codec_errors(
    subject: Any, seed: int, edits: list[tuple[float, int]], cut: float
) -> None:
    data = bytearray(subject.encode(random_message(get_interface(subject.type_name), Random(seed))))
    for where, byte in edits:
        data[int(where * (len(data) - 1))] = byte
    assert_message_or_codec_error(bytes(data[: int(cut * len(data))]))


@settings(max_examples=30)
@given(
    edits=st.lists(st.tuples(st.integers(0, 200), st.integers(0, 255)), max_size=3),
    cut=st.integers(0, 3),
)
def test_damaged_large_arrays_are_messages_or_codec_errors(
    edits: list[tuple[int, int]], cut: int
) -> None:
    image = get_message("sensor_msgs/msg/Image")()
    image.data = bytes(70_000)  # type: ignore[attr-defined]  # pyright: ignore[reportAttributeAccessIssue]
    data = bytearray(messagepack_codec_for(type(image)).encode(image))
    for where, byte in edits:
        data[where] = byte
    assert_message_or_codec_error(bytes(data[: len(data) - cut]))
