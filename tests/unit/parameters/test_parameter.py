from __future__ import annotations

import array
from typing import TYPE_CHECKING, Any

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot.errors import ArgumentTypeError, WrongStateError
from zbot.parameters.errors import ParametersFileError
from zbot.parameters.parameter import (
    Parameter,
    ParameterMismatchError,
    ParameterTypeError,
    UnknownParameterTypeError,
    get_parameter_value,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)

from rcl_interfaces.msg import ParameterType, ParameterValue

if TYPE_CHECKING:
    from pathlib import Path

Type = Parameter.Type

VALUES: list[tuple[Any, Parameter.Type]] = [
    (None, Type.NOT_SET),
    (True, Type.BOOL),
    (5, Type.INTEGER),
    (2.5, Type.DOUBLE),
    ("hello", Type.STRING),
    ([b"\x01", b"\x02"], Type.BYTE_ARRAY),
    ([], Type.BYTE_ARRAY),
    ([True, False], Type.BOOL_ARRAY),
    ([1, 2], Type.INTEGER_ARRAY),
    ((1, 2), Type.INTEGER_ARRAY),
    (array.array("i", [1, 2]), Type.INTEGER_ARRAY),
    ([1.5, 2.0], Type.DOUBLE_ARRAY),
    ([1, 2.5], Type.DOUBLE_ARRAY),
    (["a", "b"], Type.STRING_ARRAY),
]


def test_the_types_have_the_numbers_of_the_message() -> None:
    for type_ in Type:
        assert getattr(ParameterType, f"PARAMETER_{type_.name}") == type_


@pytest.mark.parametrize(("value", "expected"), VALUES)
def test_the_type_is_taken_from_the_value(value: object, expected: Parameter.Type) -> None:
    parameter: Parameter[Any] = Parameter("p", value=value)
    assert parameter.type_ is expected
    assert expected.check(parameter.value)


@pytest.mark.parametrize("value", [object(), {"a": 1}, b"bytes", [1, "a"], [None], {1, 2}, [b"ab"]])
def test_a_value_that_no_parameter_can_have_has_no_type(value: object) -> None:
    with pytest.raises(ParameterTypeError, match="a parameter is a bool, an int"):
        Parameter("p", value=value)


@pytest.mark.parametrize(
    ("type_", "value"),
    [
        (Type.NOT_SET, 1),
        (Type.BOOL, 1),
        (Type.INTEGER, 1.0),
        (Type.INTEGER, True),
        (Type.INTEGER, 2**63),
        (Type.DOUBLE, "1"),
        (Type.DOUBLE, 10**400),
        (Type.DOUBLE, True),
        (Type.STRING, 1),
        (Type.BYTE_ARRAY, [b"ab"]),
        (Type.DOUBLE_ARRAY, [1.0, "a"]),
        (Type.INTEGER_ARRAY, 1),
        (None, 2**63),
    ],
)
def test_a_value_of_another_type_is_refused(type_: Any, value: object) -> None:
    with pytest.raises(ParameterMismatchError, match=r"parameter 'p': type .* do not agree"):
        Parameter("p", type_, value)


def test_integers_widen_to_doubles() -> None:
    assert repr(Parameter("p", Type.DOUBLE, 2).value) == "2.0"
    assert repr(Parameter("p", Type.DOUBLE_ARRAY, [1, 2.5]).value) == "[1.0, 2.5]"
    assert not Type.DOUBLE.check(2)


def test_a_value_that_is_not_a_type_is_refused() -> None:
    with pytest.raises(ArgumentTypeError, match=r"type_ must be a Parameter\.Type"):
        Parameter("p", 3)  # type: ignore[call-overload]


@pytest.mark.parametrize(("value", "expected"), VALUES)
def test_a_parameter_survives_the_message(value: Any, expected: Parameter.Type) -> None:
    message = Parameter("group.p", value=value).to_parameter_msg()
    back: Parameter[Any] = Parameter.from_parameter_msg(message)
    assert (back.name, back.type_) == ("group.p", expected)
    assert back.value == (list(value) if expected.is_array else value)


def test_a_message_of_an_unknown_type_is_refused() -> None:
    with pytest.raises(UnknownParameterTypeError, match="unexpected parameter type 42"):
        parameter_value_to_python(ParameterValue(type=42))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("true", True),
        ("5", 5),
        ("5.0", 5.0),
        ("1e3", 1000.0),
        ("hello", "hello"),
        ("'5'", "5"),
        ("", ""),
        ("null", "null"),
        ("[1, 2]", [1, 2]),
        ("[1, 2.5]", [1.0, 2.5]),
        ("[true, false]", [True, False]),
        ("[a, b]", ["a", "b"]),
        ("[1, a]", "[1, a]"),
        ("[1, 2", "[1, 2"),
        ("{a: 1}", "{a: 1}"),
        ("2024-01-01", "2024-01-01"),
        ("10:30", "10:30"),
    ],
)
def test_a_text_is_read_as_yaml(text: str, value: object) -> None:
    guessed = parameter_value_to_python(get_parameter_value(text))
    assert guessed == value
    assert type(guessed) is type(value)


FILE = """
/**:
  ros__parameters: {rate: 1, shared: 'yes'}
/robot/lidar:
  ros__parameters:
    rate: 10
    filter: {size: 3}
lidar:
  ros__parameters: {rate: 7}
/robot/*:
  ros__parameters: {rate: 99}
"""


@pytest.mark.parametrize(
    ("nodes", "wildcard", "expected"),
    [
        (["/robot/lidar"], False, {"rate": 10, "filter.size": 3}),
        (["robot/lidar"], True, {"rate": 10, "shared": "yes", "filter.size": 3}),
        (["lidar"], False, {"rate": 7}),
        (None, True, {"rate": 1, "shared": "yes"}),
    ],
)
def test_a_file_gives_a_nodes_parameters(
    tmp_path: Path, nodes: list[str] | None, wildcard: bool, expected: dict[str, object]
) -> None:
    (tmp_path / "p.yaml").write_text(FILE)
    found = parameter_dict_from_yaml_file(str(tmp_path / "p.yaml"), wildcard, nodes)
    values = {name: parameter_value_to_python(parameter.value) for name, parameter in found.items()}
    assert values == expected
    assert all(name == parameter.name for name, parameter in found.items())


def test_a_namespace_is_put_before_the_names(tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text(FILE)
    found = parameter_dict_from_yaml_file(str(tmp_path / "p.yaml"), False, ["lidar"], "drive.")
    assert list(found) == ["drive.rate"]


def test_a_file_without_the_node_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(FILE)
    with pytest.raises(WrongStateError, match="does not contain any valid parameters for /x"):
        parameter_dict_from_yaml_file(str(path), target_nodes=["x"])
    with pytest.raises(ParametersFileError, match="No such file"):
        parameter_dict_from_yaml_file(str(tmp_path / "none.yaml"))


def test_a_parameter_in_place_of_its_value_is_a_mistake() -> None:
    parameter, switch = Parameter("mode", value="fast"), Parameter("debug", value=False)
    with pytest.warns(UserWarning, match=r"e\.g\. get_parameter\('mode'\)\.value == 'fast'"):
        assert parameter != "fast"
    with pytest.warns(UserWarning, match=r"its value is False: write get_parameter\('debug'\)\."):
        assert switch
    assert parameter
    assert parameter == parameter  # noqa: PLR0124 - the same object
    assert parameter != Parameter("mode", value="fast")
    assert parameter != None  # noqa: E711 - a program may ask whether it has a parameter
    assert len({parameter, switch}) == 2


def test_the_field_of_another_type_is_told() -> None:
    speed = Parameter("speed", value=1.5)
    place = r"speed is not in integer_value, but in double_value, because it is 1\.5: write get_par"
    with pytest.warns(UserWarning, match=place):
        assert speed.get_parameter_value().integer_value == 0
    assert speed.get_parameter_value().double_value == 1.5
    assert speed.get_parameter_value().type == Parameter.Type.DOUBLE
    both = [speed.get_parameter_value().integer_value, speed.get_parameter_value().double_value]
    assert both == [0, 1.5]  # a line with different fields is not told
    assert Parameter("unset").get_parameter_value().string_value == ""
