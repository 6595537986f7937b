from __future__ import annotations

import math
from pathlib import Path
from random import Random
from typing import Any

import msgpack  # type: ignore[import-untyped]
from hypothesis import given, settings
from hypothesis import strategies as st

from zbot import interfaces
from zbot.interfaces import (
    MessageSpec,
    ServiceSpec,
    get_interface,
    get_message,
    get_spec,
    interface_names,
    spec_of,
)
from zbot.interfaces.spec import INTEGER_RANGES, FieldType
from zbot.wire.codec import codec_for
from zbot.wire.errors import CodecError

packb: Any = msgpack.packb

ALPHABET = "az_/ 09é€\U0001f916\n\x00"


def random_message(message_class: type[Any], random: Random) -> Any:
    spec = spec_of(message_class)
    assert isinstance(spec, MessageSpec)
    values = {field.name: _value(field.type, random) for field in spec.fields}
    return message_class(**values)


def _value(kind: FieldType, random: Random) -> Any:
    if kind.kind == "scalar":
        return _scalar(kind, random)
    length = kind.size if kind.kind == "array" else random.randint(0, min(kind.size or 3, 3))
    return [_scalar(kind, random) for _ in range(length)]


def _scalar(kind: FieldType, random: Random) -> Any:
    if kind.is_message:
        return random_message(get_interface(kind.base), random)
    if kind.base in INTEGER_RANGES:
        low, high = INTEGER_RANGES[kind.base]
        return random.choice([low, high, random.randint(low, high), max(low, 0)])
    if kind.base == "float32":
        return random.choice([0.0, -1.5, 2.0**100, math.inf, -math.inf])
    if kind.base == "float64":
        return random.choice([0.0, -0.1, random.uniform(-1e300, 1e300), math.inf])
    if kind.base == "bool":
        return random.random() < 0.5
    if kind.base == "byte":
        return bytes((random.randint(0, 255),))
    return "".join(random.choices(ALPHABET, k=random.randint(0, min(kind.string_bound or 40, 40))))


def shipped_messages() -> list[str]:
    definitions = Path(interfaces.__file__).parent / "defs"
    names = []
    for package in (folder.name for folder in definitions.iterdir()):
        for name in interface_names(package):
            spec = get_spec(name)
            if isinstance(spec, MessageSpec):
                names.append(name)
            elif isinstance(spec, ServiceSpec):
                names += [spec.request.name, spec.response.name, spec.event.name]
            else:
                parts = (spec.goal, spec.result, spec.feedback, spec.feedback_message)
                names += [part.name for part in parts]
                names += [spec.send_goal.request.name, spec.get_result.response.name]
    return names


def test_every_shipped_type_round_trips_with_random_values() -> None:
    names = shipped_messages()
    assert len(names) > 300
    for name in names:
        message = random_message(get_interface(name), Random(name))
        codec = codec_for(type(message))
        data = codec.encode(message)
        assert codec.decode(data) == message, name
        assert codec.encode(codec.decode(memoryview(data))) == data, name


def test_a_message_of_defaults_equals_an_empty_map() -> None:
    for name in shipped_messages():
        message_class = get_interface(name)
        assert codec_for(message_class).decode(b"\x80") == message_class(), name


# Values of possible types for any field: most of the maps below are nearly valid.
FIELDS = ["data", "header", "stamp", "sec", "frame_id", "ranges", "name", "position", "pose", "x"]
FIELDS += ["covariance", "poses", "layout", "dim", "level", "values", "orientation"]
SUBJECTS = [
    codec_for(get_message(name))
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
    data = bytearray(codec_for(type(image)).encode(image))
    for where, byte in edits:
        data[where] = byte
    assert_message_or_codec_error(bytes(data[: len(data) - cut]))
