from __future__ import annotations

import importlib
from typing import Any, List, Union  # noqa: UP035 - as launch files write it

import pytest

import zbot.compat
from zbot.launch.context import LaunchContext
from zbot.launch.errors import CoercionError, EntityTypeError
from zbot.launch.frontend.entity import Entity
from zbot.launch.substitution import TextSubstitution
from zbot.launch.substitutions.value import LaunchConfiguration
from zbot.launch.typed_value import (
    extract_type,
    get_typed_value,
    is_instance_of,
    is_normalized_substitution,
    normalize_typed_substitution,
    perform_typed_substitution,
)


@pytest.mark.parametrize(
    ("text", "data_type", "expected"),
    [
        ("true", bool, True),
        ("5", int, 5),
        ("5", float, 5.0),
        ("5", str, "5"),
        ("[1, 2]", List[int], [1, 2]),  # noqa: UP006 - as above
        ("[a, b]", None, ["a", "b"]),
        ("hello", None, "hello"),
    ],
)
def test_a_configuration_becomes_a_value(text: str, data_type: Any, expected: Any) -> None:
    context = LaunchContext()
    context.launch_configurations["speed"] = text
    value = normalize_typed_substitution(LaunchConfiguration("speed"), data_type)
    found = perform_typed_substitution(context, value, data_type)
    assert found == expected
    assert type(found) is type(expected)


def test_values_are_unchanged_and_lists_are_converted() -> None:
    context = LaunchContext()
    context.launch_configurations["speed"] = "5"
    assert perform_typed_substitution(context, 3, int) == 3
    mixed = normalize_typed_substitution([3, LaunchConfiguration("speed")], list[int])
    assert not is_normalized_substitution(mixed)
    assert is_normalized_substitution(mixed[1])
    assert perform_typed_substitution(context, mixed, list[int]) == [3, 5]


@pytest.mark.parametrize(("text", "data_type"), [("fast", int), ("1.5", int), ("[a]", list[int])])
def test_a_text_of_another_type_is_refused(text: str, data_type: Any) -> None:
    value = normalize_typed_substitution(TextSubstitution(text=text), data_type)
    with pytest.raises(CoercionError):
        perform_typed_substitution(LaunchContext(), value, data_type)


@pytest.mark.parametrize(("value", "data_type"), [(5, str), (["a"], List[int]), (object(), None)])  # noqa: UP006
def test_a_value_of_another_type_is_refused_at_once(value: Any, data_type: Any) -> None:
    with pytest.raises(EntityTypeError):
        normalize_typed_substitution(value, data_type)


@pytest.mark.parametrize("data_type", [bytes, list, List, Union[int, str]])  # noqa: UP006, UP007
def test_unsupported_types_are_refused(data_type: Any) -> None:
    with pytest.raises(CoercionError):
        extract_type(data_type)


@pytest.mark.parametrize(
    ("texts", "data_type", "can_be_str", "expected"),
    [
        (["1", "2"], None, False, [1, 2]),
        (["1", "2"], list[float], False, [1.0, 2.0]),
        (["a", "2"], list[int], True, ["a", 2]),
        ("[a, 2]", None, True, ["a", 2]),
    ],
)
def test_texts_become_values(
    texts: Any, data_type: Any, can_be_str: bool, expected: list[Any]
) -> None:
    assert get_typed_value(texts, data_type, can_be_str) == expected
    assert is_instance_of(expected, data_type, can_be_str)


@pytest.mark.parametrize("texts", [["1", "2.0"], ["a", "2"], "[a, 2]", "{a: 1}"])
def test_texts_of_several_types_are_refused(texts: Any) -> None:
    with pytest.raises(CoercionError):
        get_typed_value(texts)


def test_launch_frontend_type_utils_has_the_functions_of_ros() -> None:
    zbot.compat.install_names({"launch"})
    type_utils = importlib.import_module("launch.frontend").type_utils
    assert type_utils.get_data_type_from_identifier("list_of_int") == list[int]
    assert type_utils.get_data_type_from_identifier("yaml") is None
    with pytest.raises(ValueError, match=r"the type must be one of int, .*, not 'list'"):
        type_utils.get_data_type_from_identifier("list")
    assert type_utils.check_is_list_entity(List[Entity])  # noqa: UP006 - as above
    assert not type_utils.check_is_list_entity(List[int])  # noqa: UP006 - as above
    assert not type_utils.check_is_list_entity(Entity)
    assert type_utils.is_typing_list(list[int])
    assert type_utils.coerce_to_type("1.5", float) == 1.5
    assert type_utils.check_type([1], list[int])
