"""Every message type that zbot ships, written with random values and read by foreign programs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader

import zbot.bag
from tests.unit.wire.random_message import message_of
from zbot.bag import Writer
from zbot.interfaces import MessageSpec, get_spec, interface_names
from zbot.interfaces.location import shipped_packages

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


def shipped_names() -> list[str]:
    found = (name for package in shipped_packages() for name in interface_names(package))
    return [name for name in found if isinstance(get_spec(name), MessageSpec)]


def uses_wide_text(name: str, seen: frozenset[str] = frozenset()) -> bool:
    """Return whether a type has a wstring, which CDR readers of others do not agree on."""
    spec: Any = get_spec(name)
    return any(
        field.type.base == "wstring"
        or (
            field.type.is_message
            and field.type.base not in seen
            and uses_wide_text(field.type.base, seen | {name})
        )
        for field in spec.fields
    )


def hash_differs(name: str) -> bool:
    """Return whether rosbags computes another hash than ROS 2: for `char`, `byte` and `wstring`."""
    spec: Any = get_spec(name)
    return any(
        field.type.base in {"char", "byte", "wstring"}
        or (field.type.is_message and hash_differs(field.type.base))
        for field in spec.fields
    )


@pytest.fixture(scope="module")
def messages() -> dict[str, Any]:
    """Return a message of each type by its topic."""
    return {
        f"/{name.replace('/', '_')}": message_of(name)
        for name in shipped_names()
        if not uses_wide_text(name)
    }


@pytest.fixture
def bag(path: Path, messages: dict[str, Any]) -> Path:
    with Writer(path) as writer:
        for number, (topic, message) in enumerate(messages.items()):
            writer.write(topic, message, number)
    return path


def is_same(ours: Any, theirs: Any) -> bool:
    if isinstance(ours, bytes) and isinstance(theirs, int):
        return ours == bytes((theirs,))
    # mcap-ros2-support reads `char` as int8. In ROS 2 it is uint8.
    if isinstance(theirs, int) and not isinstance(theirs, bool) and -128 <= theirs < 0:
        return int(ours) in {theirs, theirs + 256}
    return bool(ours == theirs)


def differences(ours: Any, theirs: Any, where: str) -> Iterator[str]:
    """Yield the paths of fields that are different."""
    if hasattr(ours, "get_fields_and_field_types"):
        for name in ours.get_fields_and_field_types():
            yield from differences(getattr(ours, name), getattr(theirs, name), f"{where}.{name}")
    elif isinstance(ours, (str, bytes)) or not hasattr(ours, "__len__"):
        if not is_same(ours, theirs):
            yield f"{where}: {ours!r} {theirs!r}"
    elif len(ours) != len(theirs):
        yield where
    else:
        for number, (one, other) in enumerate(zip(ours, theirs, strict=True)):
            yield from differences(one, other, f"{where}[{number}]")


def test_zbot_reads_every_type(bag: Path, messages: dict[str, Any]) -> None:
    found = {topic: message for topic, message, _ in zbot.bag.read(bag)}
    assert len(found) > 300
    assert found == messages


def test_mcap_ros2_support_reads_every_type(bag: Path, messages: dict[str, Any]) -> None:
    wrong: list[str] = []
    count = 0
    with (bag / "lesson_0.mcap").open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        for _, channel, _, decoded in reader.iter_decoded_messages():
            wrong += differences(messages[channel.topic], decoded, channel.topic)
            count += 1
    assert (wrong, count) == ([], len(messages))


def test_rosbags_reads_every_type(path: Path, messages: dict[str, Any]) -> None:
    own = {
        topic: message
        for topic, message in messages.items()
        if not hash_differs(topic[1:].replace("_msg_", "/msg/"))
    }
    with Writer(path) as writer:
        for number, (topic, message) in enumerate(own.items()):
            writer.write(topic, message, number)
    wrong: list[str] = []
    count = 0
    with AnyReader([path]) as bag:
        for connection, _, data in bag.messages():
            decoded = bag.deserialize(data, connection.msgtype)
            wrong += differences(own[connection.topic], decoded, connection.topic)
            count += 1
    assert (wrong, count) == ([], len(own))
    assert count > 300
