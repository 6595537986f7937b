"""Tests of message types that come from bags."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from mcap.writer import Writer as McapLibraryWriter

import zbot.bag
from zbot.bag import Reader, Writer
from zbot.bag.definition import definition_text, message_class, split_definitions
from zbot.bag.description import description
from zbot.bag.errors import (
    BagTypeError,
)
from zbot.bag.message import Definition
from zbot.bag.metadata import TopicMetadata

if TYPE_CHECKING:
    from pathlib import Path


def test_types_that_are_unknown_here_come_from_the_bag(path: Path) -> None:
    definition = f'zoo_msgs/Leg[2] legs\nstring NAME="x"\n{"=" * 80}\nMSG: zoo_msgs/Leg\nint8 n\n'
    with Writer(path) as bag:
        bag.create_topic(
            TopicMetadata("/cow", "zoo_msgs/msg/Cow"),
            Definition("ros2msg", definition),
        )
        bag.write_serialized("/cow", b"\x00\x01\x00\x00\x03\x04", 1)
    [(_, cow, _)] = zbot.bag.read(path)
    assert [leg.n for leg in cow.legs] == [3, 4]
    assert cow.NAME == "x"


def test_a_name_without_msg_is_read() -> None:
    string = message_class("std_msgs/String", "ros2msg", "string data\n")
    assert string is message_class("std_msgs/msg/String")


def test_a_type_that_differs_here_is_refused(path: Path) -> None:
    with Writer(path) as bag:
        bag.create_topic(
            TopicMetadata("/a", "std_msgs/msg/String"),
            Definition("ros2msg", "int32 data\n"),
        )
        bag.write_serialized("/a", b"\x00\x01\x00\x00\x03\x04\x05\x06", 1)
    with pytest.raises(BagTypeError, match="std_msgs/msg/String is defined differently here"):
        list(zbot.bag.read(path))


def test_a_type_without_a_definition_is_refused() -> None:
    with pytest.raises(BagTypeError, match="neither the bag nor this machine"):
        message_class("nowhere_msgs/msg/Thing")
    with pytest.raises(BagTypeError, match="encoding ros2idl"):
        message_class("nowhere_msgs/msg/Thing", "ros2idl", "module x {}")


def test_messages_of_other_formats_are_listed_and_refused(tmp_path: Path) -> None:
    path = tmp_path / "web.mcap"
    with path.open("wb") as stream:
        writer: Any = McapLibraryWriter(stream)  # it has no types
        writer.start()
        channel = writer.register_channel("/web", "json", 0)
        writer.add_message(channel, 5, b"{}", 5)
        writer.finish()
    with Reader(path) as bag:
        assert [message.data for message in bag.messages()] == [b"{}"]
        assert "Topic: /web | Type:  | Count: 1 | Ser" in description(bag.metadata)
    with pytest.raises(BagTypeError, match="in the format 'json', not in CDR"):
        list(zbot.bag.read(path))


def test_definitions_are_taken_apart() -> None:
    parts = split_definitions("geometry_msgs/msg/Twist", definition_text("geometry_msgs/msg/Twist"))
    assert list(parts) == ["geometry_msgs/msg/Twist", "geometry_msgs/msg/Vector3"]
