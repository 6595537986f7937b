"""Tests of the contents of definitions, as `rosidl_adapter.parser` gives them."""

from __future__ import annotations

import importlib
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot.compat
from tests.conftest import allowed
from zbot.compat.rosidl.definition_text import (
    BaseType,
    Constant,
    Field,
    InvalidActionSpecification,
    InvalidFieldDefinition,
    InvalidResourceName,
    InvalidServiceSpecification,
    InvalidValue,
    MessageSpecification,
    Type,
    UnknownMessageType,
    parse_action_string,
    parse_message_file,
    parse_message_string,
    parse_service_string,
    parse_value_string,
    validate_field_types,
)

if TYPE_CHECKING:
    from pathlib import Path

BOAT = """\
# A boat.
#
# It floats.

# its length [m]
float64 length 4.5   # at the waterline
   # without the rudder
geometry_msgs/Point[<=3] anchors
string<=8[2] names ["a", "b, c"]
Sail sail
byte[] flags
byte LEAK=2  # a leak
string FLAG='red'
"""


def test_a_message_has_its_fields_and_constants() -> None:
    boat = parse_message_string("harbour_msgs", "Boat", BOAT)
    assert (boat.base_type.pkg_name, boat.base_type.type, boat.msg_name) == (
        "harbour_msgs",
        "Boat",
        "Boat",
    )
    assert [(str(field.type), field.name, field.default_value) for field in boat.fields] == [
        ("float64", "length", 4.5),
        ("geometry_msgs/Point[<=3]", "anchors", None),
        ("string<=8[2]", "names", ["a", "b, c"]),
        ("harbour_msgs/Sail", "sail", None),
        ("byte[]", "flags", None),
    ]
    assert [(constant.type, constant.name, constant.value) for constant in boat.constants] == [
        ("byte", "LEAK", 2),
        ("string", "FLAG", "red"),
    ]
    again = parse_message_string("harbour_msgs", "Boat", str(boat))
    assert again == boat
    assert again != parse_message_string("harbour_msgs", "Ship", str(boat))


def test_comments_belong_to_the_parts_beside_them() -> None:
    boat = parse_message_string("harbour_msgs", "Boat", BOAT)
    assert boat.annotations == {"comment": ["A boat.", "", "It floats."]}
    length = ["its length", "at the waterline", "without the rudder"]
    found = boat.fields[0].annotations
    assert found["unit"] == "m"
    assert [line.strip() for line in found["comment"]] == length
    assert boat.constants[0].annotations == {"comment": ["a leak"]}
    assert boat.fields[1].annotations == {"comment": []}


@pytest.mark.parametrize(
    ("text", "is_dynamic", "is_fixed", "size", "is_bound"),
    [
        ("int8", False, False, None, False),
        ("int8[]", True, False, None, False),
        ("int8[3]", False, True, 3, False),
        ("int8[<=3]", True, False, 3, True),
    ],
)
def test_a_type_tells_the_kind_of_its_array(
    text: str, is_dynamic: bool, is_fixed: bool, size: int | None, is_bound: bool
) -> None:
    kind = Type(text)
    assert (kind.is_dynamic_array(), kind.is_fixed_size_array()) == (is_dynamic, is_fixed)
    assert (kind.is_array, kind.array_size) == (is_dynamic or is_fixed, size)
    assert kind.is_upper_bound is is_bound
    assert str(kind) == text
    assert kind == Type(text)
    assert kind.is_primitive_type()


def test_a_name_without_a_package_is_in_the_given_package() -> None:
    assert str(BaseType("Boat", "harbour_msgs")) == "harbour_msgs/Boat"
    assert BaseType("string<=5").string_upper_bound == 5
    for wrong in ("Boat", "harbour_msgs/boat", "int8[]", "string<=0", "int"):
        with pytest.raises(InvalidResourceName):
            BaseType(wrong)


def test_mistakes_are_explained() -> None:
    with pytest.raises(InvalidFieldDefinition, match=r"1: .*only one word"):
        parse_message_string("harbour_msgs", "Boat", "float64")
    for error in (TypeError, NameError, ValueError):  # rosidl_adapter raises one of them
        with pytest.raises(error, match="'Speed' is not valid"):
            parse_message_string("harbour_msgs", "Boat", "float64 Speed")
    with pytest.raises(InvalidServiceSpecification, match="'---'"):
        parse_service_string("harbour_msgs", "Moor", "bool ok")
    with pytest.raises(InvalidActionSpecification, match="'---'"):
        parse_action_string("harbour_msgs", "Sail", "bool ok\n---\n")
    with pytest.raises(InvalidValue, match="value '300' can not be converted to type 'uint8'"):
        Constant("uint8", "SPEED", "300")
    with pytest.raises(NameError, match="field name 'Speed' is not valid"):
        Field(Type("uint8"), "Speed")
    with pytest.raises(ValueError, match="harbour_msgs/Boat has more than one speed"):
        MessageSpecification("harbour_msgs", "Boat", [Field(Type("int8"), "speed")] * 2, [])


def test_arguments_of_other_types_are_refused() -> None:
    boat: Any = "harbour_msgs/Boat"
    for make in (
        lambda: Field(boat, "boat"),
        lambda: Constant(boat, "BOAT", "1"),
        lambda: MessageSpecification("harbour_msgs", "Boat", [boat], []),
    ):
        with pytest.raises(TypeError, match=r"must be a.*, not str: 'harbour_msgs/Boat'"):
            make()
    with pytest.raises(NotImplementedError):
        parse_value_string(Type(boat), "1")
    nothing: Any = None
    with pytest.raises(ValueError, match="it is not a str"):
        Constant("bool", "LEAK", nothing)


def test_types_of_fields_can_be_checked() -> None:
    boat = parse_message_string("harbour_msgs", "Boat", "int8 size\nharbour_msgs/Sail[3] sails")
    with pytest.raises(UnknownMessageType, match=r"'harbour_msgs/Sail\[3\] sails' is not known"):
        validate_field_types(boat, [])
    validate_field_types(boat, [BaseType("harbour_msgs/Sail")])


def test_services_and_actions_have_their_messages() -> None:
    service = parse_service_string("harbour_msgs", "Moor", "string place\n---\nbool ok")
    assert (service.srv_name, service.request.msg_name) == ("Moor", "Moor_Request")
    assert [field.name for field in service.response.fields] == ["ok"]
    action = parse_action_string("harbour_msgs", "Sail", "string to\n---\n---\nfloat64 left")
    assert [field.name for field in action.goal.fields] == ["to"]
    assert [field.name for field in action.feedback.fields] == ["left"]


def test_rosidl_adapter_reads_a_file(tmp_path: Path) -> None:
    zbot.compat.install_names({"rosidl_adapter"})
    parser = importlib.import_module("rosidl_adapter.parser")
    file = tmp_path / "Boat.msg"
    file.write_text(BOAT, encoding="utf-8")
    assert parser.parse_message_file("harbour_msgs", str(file)) == parse_message_file(
        "harbour_msgs", file
    )


def test_many_fields_and_brackets_take_little_time() -> None:
    begin = time.process_time()
    lines = "".join(f"int32 a{number}\n" for number in range(10_000))
    message = parse_message_string("harbour_msgs", "Boat", f"{lines}int32 b # {'[' * 100_000}")
    assert len(message.fields) == 10_001
    assert time.process_time() - begin < allowed(3)
