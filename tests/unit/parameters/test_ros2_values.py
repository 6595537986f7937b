"""Values of parameters in YAML, compared with the values that rclpy 9.1.2 reads.

`data/ros2_values.json` has the texts with what rclpy reads: `f:` is a float, `i:` an integer, `b:`
a bool, `s:` a string, and null is an error.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from zbot.parameters.errors import ParametersFileError, ParameterValueError
from zbot.parameters.file import load, parse_value
from zbot.parameters.parameter import infer_parameter

RECORDED: dict[str, Any] = json.loads(
    Path(__file__).with_name("data").joinpath("ros2_values.json").read_text(encoding="utf-8")
)


def shown(value: Any) -> Any:
    if isinstance(value, list):
        return [shown(item) for item in value]
    kind = {bool: "b", int: "i", float: "f", str: "s"}[type(value)]
    return f"{kind}:{value if isinstance(value, str) else repr(value)}"


def typed(value: Any) -> Any:
    return shown(infer_parameter("x", value).value)


@pytest.mark.parametrize(("text", "expected"), RECORDED["values"].items())
def test_a_value_on_the_command_line_is_what_rclpy_reads(text: str, expected: Any) -> None:
    if expected is None:
        with pytest.raises(ParameterValueError):
            parse_value(text, of_one_kind=True)
    else:
        assert typed(parse_value(text, of_one_kind=True)) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("[]", []),
        ("[1, 2.0]", ["f:1.0", "f:2.0"]),
        ("[1, .inf]", ["f:1.0", "f:inf"]),
        ("[&a 1, *a]", ["i:1", "i:1"]),
        ("[x, y]", ["s:x", "s:y"]),
        ("|", "s:"),
    ],
)
def test_some_values_are_read_that_rclpy_refuses(text: str, expected: Any) -> None:
    assert typed(parse_value(text, of_one_kind=True)) == expected


@pytest.mark.parametrize("text", ["[[1, 2], [3]]", "[[1]]", "[1, [2]]", "[[1], 2]", "a\n---\nb"])
def test_values_of_which_a_part_would_be_lost_are_refused(text: str) -> None:
    with pytest.raises(ParameterValueError):
        parse_value(text, of_one_kind=True)


@pytest.mark.parametrize(("text", "expected"), RECORDED["files"])
def test_a_parameter_file_is_read_as_rclpy_reads_it(
    tmp_path: Path, text: str | list[int], expected: Any
) -> None:
    path = tmp_path / "p.yaml"
    path.write_bytes(text.encode() if isinstance(text, str) else bytes(text))
    if expected is None:
        with pytest.raises(ParametersFileError):
            load(str(path), "/n")
        return
    for node, values in expected.items():
        found = load(str(path), f"/{node.removeprefix('/')}")
        assert {name: typed(value) for name, value in found.items()} == values


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("axes: [x, y, z]", {"axes": ["x", "y", "z"]}),
        ("x: {}", {}),
        ("x: []", {"x": []}),
        ("a: &a {x: 1, y: 2}\nb: {<<: *a, y: 3}", {"a.x": 1, "a.y": 2, "b.x": 1, "b.y": 3}),
        ("x: 1\nx: a", {"x": "a"}),
    ],
)
def test_a_parameter_file_may_have_more_than_rclpy_reads(
    tmp_path: Path, text: str, expected: Any
) -> None:
    path = tmp_path / "p.yaml"
    indented = "".join(f"    {line}\n" for line in text.splitlines())
    path.write_text(f"/n:\n  ros__parameters:\n{indented}", encoding="utf-8")
    assert load(str(path), "/n") == expected


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("l:\n  - name: x\n    gain: 2", "line 5: 'l.name' is in a list, so 'gain' cannot follow"),
        ("l:\n  - [1, 2]\n  - a: 3", "line 4: 'l' is a list, so it cannot contain a list"),
        ("x:\ny: 1", "line 3: 'x' has no value"),
        ("'': 1", "line 3: a parameter's name is missing"),
        ("[a, b]: 1", "line 3: a parameter's name is missing"),
    ],
)
def test_a_part_that_cannot_be_read_is_named_with_its_line(
    tmp_path: Path, text: str, reason: str
) -> None:
    path = tmp_path / "p.yaml"
    indented = "".join(f"    {line}\n" for line in text.splitlines())
    path.write_text(f"/n:\n  ros__parameters:\n{indented}", encoding="utf-8")
    with pytest.raises(ParametersFileError, match=reason):
        load(str(path), "/n")
