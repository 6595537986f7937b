from __future__ import annotations

import sys
from types import ModuleType

import pytest

from zbot import errors


def test_every_error_belongs_to_the_tree() -> None:
    classes = {item for item in vars(errors).values() if isinstance(item, type)}
    outside = {item for item in classes if not issubclass(item, errors.ZbotError)}
    assert outside == {errors.ExternalShutdownException}  # `except ZbotError` does not stop an end


@pytest.mark.parametrize(
    ("error", "builtin"),
    [
        (errors.ArgumentTypeError("depth", "an integer", "x"), TypeError),
        (errors.InvalidNodeNameError("a b", "reason", 1), ValueError),
        (errors.InvalidParameterError(""), ValueError),
    ],
)
def test_each_error_is_also_a_builtin_exception(
    error: errors.ZbotError, builtin: type[Exception]
) -> None:
    assert isinstance(error, builtin)


def test_a_number_that_python_does_not_write_has_a_text() -> None:
    assert errors.shortened([16**5000]) == "a value with a number of thousands of digits"


def test_arguments_are_kept_as_attributes() -> None:
    error = errors.InvalidNameError("topic name", "a b", "a space is not allowed", 1)
    assert (error.name_type, error.name, error.error_msg, error.invalid_index) == (
        "topic name",
        "a b",
        "a space is not allowed",
        1,
    )


def test_a_parameter_error_lists_the_names() -> None:
    error = errors.ParameterError("unknown parameters", ["a", "b"])
    assert error.parameters == ["a", "b"]
    assert str(error) == "unknown parameters: 'a', 'b'"


def test_a_missing_init_names_the_library_of_the_program(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, "rclpy", raising=False)
    assert "needs zbot.init() first" in str(errors.NotInitializedError())
    monkeypatch.setitem(sys.modules, "rclpy", ModuleType("rclpy"))
    assert "needs rclpy.init() first" in str(errors.NotInitializedError())


@pytest.mark.parametrize(
    ("number", "text"), [(0, "0 messages"), (1, "1 message"), (2, "2 messages")]
)
def test_a_number_has_the_right_form_of_its_noun(number: int, text: str) -> None:
    assert errors.counted(number, "message") == text
