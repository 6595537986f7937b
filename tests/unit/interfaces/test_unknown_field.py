from __future__ import annotations

import pytest

from zbot.interfaces.message_reader import FieldMisfitError, MessageReader
from zbot.interfaces.unknown_field import add_advice

from geometry_msgs.msg import Twist, Vector3
from std_msgs.msg import Int8


def text_after_advice(message: object, field: str) -> str:
    with pytest.raises(AttributeError) as caught:
        setattr(message, field, 1.0)
    add_advice(caught.value)
    add_advice(caught.value)
    return str(caught.value)


def test_an_assignment_of_an_unknown_field_names_the_nearest() -> None:
    text = text_after_advice(Twist(), "liner")
    assert text.startswith("'Twist' object has no attribute 'liner'")
    assert text.endswith("; did you mean 'linear'?")
    assert text.count("did you mean") == 1


def test_an_assignment_of_an_unknown_field_names_all_if_none_is_near() -> None:
    assert text_after_advice(Vector3(), "speed").endswith("; it has x, y, z")


def test_reading_an_unknown_field_names_the_fields_too() -> None:
    with pytest.raises(AttributeError) as caught:
        _ = Vector3().speed  # type: ignore[attr-defined]
    add_advice(caught.value)
    assert str(caught.value) == "'Vector3' object has no attribute 'speed'; it has x, y, z"
    assert caught.value.obj is None  # Python suggests no second name


def test_a_class_with_the_name_of_a_message_class_is_left_alone() -> None:
    class Twist:
        __slots__ = ()

    # At an assignment, only Python 3.13 says which object it was.
    with pytest.raises(AttributeError) as caught:
        _ = Twist().liner  # type: ignore[attr-defined]
    add_advice(caught.value)
    assert "; " not in str(caught.value)


def test_errors_of_other_objects_are_left_alone() -> None:
    class Robot:
        __slots__ = ()

    assert "; " not in text_after_advice(Robot(), "speed")
    error = ValueError("'Int8' object has no attribute 'dta'")
    add_advice(error)
    assert str(error) == "'Int8' object has no attribute 'dta'"
    assert Int8().data == 0


def test_a_number_is_no_name_of_a_field() -> None:
    with pytest.raises(FieldMisfitError, match="no attribute '5'"):
        MessageReader().message(Vector3, {5: 1.0})
