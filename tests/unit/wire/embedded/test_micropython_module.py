"""Tests of the modules for MicroPython. CPython runs them here."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from tests.unit.wire.random_message import ALPHABET, random_message
from zbot.interfaces import get_interface, interface_names
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.embedded.included_types import interfaces_of, messages_of
from zbot.wire.embedded.micropython_module import micropython_module

_PACKAGES = ("test_msgs", "std_msgs", "geometry_msgs", "sensor_msgs", "nav_msgs", "std_srvs")


def _module(*names: str) -> dict[str, Any]:
    module: dict[str, Any] = {}
    exec(micropython_module(names), module)
    return module


def test_a_hundred_types_have_the_bytes_of_zbot_in_both_directions() -> None:
    names = [name for package in _PACKAGES for name in interface_names(package)]
    module = _module(*names)
    classes = {cls.TYPE_NAME: cls for cls in module.values() if hasattr(cls, "TYPE_NAME")}
    specs = messages_of(interfaces_of(names))
    assert len(specs) > 100
    random = Random(33)
    for spec in specs:
        cls = get_interface(spec.name)
        codec = cdr_codec_for(cls)
        data = codec.encode(random_message(cls, random, ALPHABET))
        copy = module["read"](classes[spec.name], data)
        assert module["write"](copy) == data, spec.name
        assert module["write"](classes[spec.name]()) == codec.encode(cls()), spec.name
        with pytest.raises(module["CdrError"]):
            module["read"](classes[spec.name], data[: random.randrange(len(data))])


def test_fields_have_the_names_of_the_definition() -> None:
    module = _module("sensor_msgs/msg/Temperature", "std_srvs/srv/SetBool")
    message = module["Temperature"](temperature=23.5)
    message.header.frame_id = "board"
    data = module["write"](message)
    cls = get_interface("sensor_msgs/msg/Temperature")
    decoded = cdr_codec_for(cls).decode(data)
    assert (decoded.temperature, decoded.header.frame_id) == (23.5, "board")
    assert module["read"](module["Temperature"], data).temperature == 23.5
    assert module["SetBool"].Request(data=True).data is True
    assert module["SetBool"].TYPE_NAME == "std_srvs/srv/SetBool"


@pytest.mark.parametrize(
    ("name", "values", "reason"),
    [
        ("std_msgs/msg/UInt8", {"data": 256}, "256 does not fit into 1 bytes"),
        ("std_msgs/msg/Int16", {"data": -40000}, "-40000 does not fit into 2 bytes"),
        (
            "test_msgs/msg/BoundedPlainSequences",
            {"int32_values": [1, 2, 3, 4]},
            "a sequence has 4 items, but at most 3 are allowed",
        ),
        (
            "sensor_msgs/msg/Imu",
            {"orientation_covariance": [0.0]},
            "an array has 1 items, but needs 9",
        ),
    ],
)
def test_a_wrong_value_is_refused(name: str, values: dict[str, Any], reason: str) -> None:
    module = _module(name)
    message = module[name.rpartition("/")[2]](**values)
    with pytest.raises(module["CdrError"], match=reason):
        module["write"](message)


def test_equal_names_of_two_packages_become_full_names() -> None:
    module = _module("geometry_msgs/msg/Pose", "turtlesim/msg/Pose")
    assert module["geometry_msgs_msg_Pose"].TYPE_NAME == "geometry_msgs/msg/Pose"
    assert module["turtlesim_msg_Pose"].TYPE_NAME == "turtlesim/msg/Pose"
    assert "Pose" not in module


def test_numbers_of_a_sender_with_the_other_byte_order_are_read() -> None:
    module = _module("std_msgs/msg/Int32")
    assert module["read"](module["Int32"], b"\0\0\0\0\0\0\1\2").data == 258
