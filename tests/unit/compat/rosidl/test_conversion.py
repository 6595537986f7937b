"""Tests of messages as dictionaries, YAML and CSV, and of types by name."""

from __future__ import annotations

from collections import OrderedDict
from pathlib import Path
from typing import Any

import pytest

from zbot.compat.rosidl import lookup
from zbot.compat.rosidl.conversion import (
    convert_value,
    get_message_slot_types,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
)
from zbot.compat.rosidl.lookup import get_action, get_interface, get_message, get_service
from zbot.interfaces import slot_type as idl
from zbot.interfaces.set_fields import set_message_fields

import example_interfaces.action
from builtin_interfaces.msg import Time
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from geometry_msgs.msg import Point32, Polygon, PoseStamped, PoseWithCovariance
from rcl_interfaces.msg import ParameterDescriptor
from sensor_msgs.msg import JointState
from std_msgs.msg import Header, Int8, String, UInt8MultiArray

NAMED = JointState(name=["left", "right"], position=[0.5, 1.5])


def test_a_dictionary_has_the_fields_in_order_and_plain_values() -> None:
    found = message_to_ordereddict(NAMED)
    assert type(found) is type(found["header"]["stamp"]) is OrderedDict
    assert list(found) == ["header", "name", "position", "velocity", "effort"]
    assert found["name"] == ["left", "right"]
    assert found["position"] == [0.5, 1.5]
    assert type(found["position"]) is list


@pytest.mark.parametrize(
    ("options", "name", "position"),
    [
        ({"truncate_length": 1}, ["l...", "..."], [0.5, "..."]),
        ({"truncate_length": 9}, ["left", "right"], [0.5, 1.5]),
        (
            {"no_arr": True},
            "<sequence type: string, length: 2>",
            "<sequence type: double, length: 2>",
        ),
        ({"no_str": True}, ["<string length: <4>>", "<string length: <5>>"], [0.5, 1.5]),
    ],
)
def test_long_values_are_shortened_by_the_options(
    options: dict[str, Any], name: Any, position: Any
) -> None:
    found = message_to_ordereddict(NAMED, **options)
    assert (found["name"], found["position"]) == (name, position)


def test_yaml_is_a_block_with_one_line_per_element() -> None:
    text = message_to_yaml(NAMED)
    assert "position:\n- 0.5\n- 1.5\n" in text
    assert message_to_yaml(String(data="a"), flow_style=True) == "{data: a}\n"


def test_csv_has_every_value() -> None:
    assert message_to_csv(NAMED) == "0,0,,left,right,0.5,1.5"
    assert message_to_csv(NAMED, truncate_length=1) == "0,0,,l...,...,0.5,..."


def test_a_serialized_message_becomes_its_bytes() -> None:
    octets = b"\x00\x01"
    assert message_to_ordereddict(octets) == {"bytes": octets}
    assert message_to_csv(octets) == str(octets)
    assert "AAE=" in message_to_yaml(octets)


def test_slot_types_have_the_classes_of_rosidl_parser() -> None:
    assert get_message_slot_types(JointState()) == {
        "header": idl.NamespacedType(["std_msgs", "msg"], "Header"),
        "name": idl.UnboundedSequence(idl.UnboundedString()),
        "position": idl.UnboundedSequence(idl.BasicType("double")),
        "velocity": idl.UnboundedSequence(idl.BasicType("double")),
        "effort": idl.UnboundedSequence(idl.BasicType("double")),
    }
    assert PoseWithCovariance.SLOT_TYPES[1] == idl.Array(idl.BasicType("double"), 36)
    assert idl.BoundedSequence(
        idl.NamespacedType(["rcl_interfaces", "msg"], "IntegerRange"), 1
    ) in (ParameterDescriptor.SLOT_TYPES)


@pytest.mark.parametrize(
    ("slot", "is_bounded"),
    [
        (idl.UnboundedString(), False),
        (idl.BoundedString(3), True),
        (idl.UnboundedSequence(idl.BasicType("double")), False),
        (idl.BoundedSequence(idl.BasicType("double"), 3), True),
        (idl.Array(idl.BasicType("double"), 3), True),
    ],
)
def test_types_say_whether_they_are_bounded(slot: Any, is_bounded: bool) -> None:
    assert slot.has_maximum_size() is is_bounded


def test_fields_are_set_and_others_keep_their_values() -> None:
    message = PoseStamped(header=Header(frame_id="map"))
    values = {"pose": {"position": {"x": 1, "y": "2.5"}}}
    assert set_message_fields(message, values) == []
    assert (message.pose.position.x, message.pose.position.y) == (1.0, 2.5)
    assert message.header.frame_id == "map"
    assert values == {"pose": {"position": {"x": 1, "y": "2.5"}}}


def test_lists_of_messages_are_made_of_dictionaries_and_of_messages() -> None:
    status = {"name": "a", "level": 2, "values": [{"key": "k"}, KeyValue(key="l")]}
    message = DiagnosticArray()
    set_message_fields(message, {"status": [status, DiagnosticStatus(name="b")]})
    assert [each.name for each in message.status] == ["a", "b"]
    assert message.status[0].level == DiagnosticStatus.ERROR
    assert [value.key for value in message.status[0].values] == ["k", "l"]
    polygon = Polygon()
    set_message_fields(polygon, {"points": [{"x": 1.0}]})
    assert polygon.points == [Point32(x=1.0)]


def test_the_dictionary_of_a_message_restores_the_message() -> None:
    for message in (NAMED, PoseWithCovariance(), UInt8MultiArray(data=[1, 2])):
        twin = type(message)()
        set_message_fields(twin, message_to_ordereddict(message))
        assert twin == message


@pytest.mark.parametrize(
    "values", [{"header": "auto"}, {"header": {"stamp": "now", "frame_id": ""}}]
)
def test_auto_and_now_return_setters_for_the_time(values: dict[str, Any]) -> None:
    message = PoseStamped()
    (setter,) = set_message_fields(message, values, True, True)
    setter(Time(sec=4))
    assert message.header == Header(stamp=Time(sec=4))
    word = values["header"] if values["header"] == "auto" else "now"
    sentence = f"^Value '{word}' is expected to be a dictionary but is a str$"
    with pytest.raises(TypeError, match=sentence):
        set_message_fields(message, values)


@pytest.mark.parametrize(
    ("values", "error"),
    [
        ({"nothing": 1}, AttributeError),
        ({"pose": {"position": {"x": "far"}}}, ValueError),
        ({"pose": {"position": 3}}, TypeError),
        ("pose", TypeError),
    ],
)
def test_values_that_do_not_fit_are_refused(values: Any, error: type[Exception]) -> None:
    with pytest.raises(error):
        set_message_fields(PoseStamped(), values)


def test_classes_are_found_by_name() -> None:
    assert get_message("std_msgs/msg/String") is get_message("std_msgs/String") is String
    assert get_service("std_srvs/srv/Empty") is get_interface("std_srvs/srv/Empty")
    assert get_action("example_interfaces/Fibonacci") is example_interfaces.action.Fibonacci


@pytest.mark.parametrize(
    ("name", "error"),
    [
        ("String", ValueError),
        ("std_msgs/msg/", ValueError),
        ("too/many/parts/here", ValueError),
        ("std_srvs/srv/Empty", ValueError),
        ("std_msgs/msg/Sting", AttributeError),
        ("no_such_msgs/msg/String", ModuleNotFoundError),
    ],
)
def test_a_wrong_message_name_raises_the_error_of_ros(name: str, error: type[Exception]) -> None:
    with pytest.raises(error):
        get_message(name)


def test_the_class_of_a_slot_is_imported() -> None:
    slot = idl.NamespacedType(["std_msgs", "msg"], "String")
    assert lookup.import_message_from_namespaced_type(slot) is String
    with pytest.warns(DeprecationWarning, match="value_type"):
        assert lookup.import_message_from_namespaced_type(idl.UnboundedSequence(slot)) is String


def test_interfaces_are_listed_by_package_and_kind() -> None:
    assert "std_msgs" in lookup.get_interface_packages()
    assert lookup.get_service_interfaces(["std_srvs"]) == {
        "std_srvs": ["srv/Empty", "srv/SetBool", "srv/Trigger"]
    }
    assert lookup.get_message_interfaces(["std_srvs", "zbot"]) == {}
    assert lookup.get_action_interfaces(["example_interfaces"])
    with pytest.raises(LookupError):
        lookup.get_interfaces(["no_such_package"])


@pytest.mark.parametrize("name", ["std_msgs/msg/String", "std_msgs/msg/String.msg"])
def test_the_file_of_an_interface_is_found(name: str) -> None:
    assert "string data" in Path(lookup.get_interface_path(name)).read_text(encoding="utf-8")


def test_a_file_that_is_not_there_is_a_lookup_error() -> None:
    with pytest.raises(LookupError):
        lookup.get_interface_path("std_msgs/msg/Sting")


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ((1, 2, 3), (1, 2, "...")),
        (["123", "4"], ["12...", "4"]),
        (b"hello", "he..."),
        ({"long": "123"}, {"long": "12..."}),
        (Header(frame_id="map"), {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": "ma..."}),
        (5, 5),
    ],
)
def test_any_value_is_shortened(value: Any, expected: Any) -> None:
    assert convert_value(value, truncate_length=2) == expected


@pytest.mark.parametrize(
    ("values", "kind", "sentence"),
    [
        ({"dta": 1}, AttributeError, "'Int8' object has no attribute 'dta'; did you mean 'data'?"),
        (
            {"data": "x"},
            ValueError,
            "field 'data' of std_msgs/msg/Int8 must be of the type int8, not 'x'",
        ),
    ],
)
def test_an_error_names_the_field_and_what_is_near(
    values: dict[str, Any], kind: type[Exception], sentence: str
) -> None:
    with pytest.raises(kind) as caught:
        set_message_fields(Int8(), values)
    assert str(caught.value) == sentence
