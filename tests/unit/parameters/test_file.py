from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

from zbot.parameters.errors import ParametersFileError, ParameterValueError
from zbot.parameters.file import load, matches, parse_value, sections, unused

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1),
        ("-7", -7),
        ("1_000", "1_000"),
        ("0x1F", 31),
        ("1.5", 1.5),
        ("1e3", 1000.0),
        (".5", 0.5),
        ("-.inf", -math.inf),
        ("true", True),
        ("off", False),
        ("hello", "hello"),
        ("'007'", "007"),
        ("!!str 5", "5"),
        ("2020-01-01", "2020-01-01"),
        ("1:30", "1:30"),
        ("08", 8.0),
        ("null", "null"),
        ("~", "~"),
        ("[1, 2]", [1, 2]),
        ("[a, 'b c']", ["a", "b c"]),
        ("[]", []),
    ],
)
def test_a_value_has_the_type_that_ros_reads(text: str, value: object) -> None:
    read = parse_value(text)
    assert read == value
    assert type(read) is type(value)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("{a: 1}", "a bool, a number, a string or a list"),
        ("", "a bool, a number, a string or a list"),
        ("[[1]]", "a bool, a number, a string or a list"),
        ("[a, b", "line 1, column 6"),
        ("a: b: c", "mapping values are not allowed here; a line before it needs a colon at its"),
        ("**: 1", "a text that begins with [*] needs quotes, and all nodes are /[*][*]"),
        ("&a [*a]", "inside its own value"),
        ("[" * 5000, "deeper than 100 levels"),
    ],
)
def test_a_value_that_no_parameter_can_have_is_rejected(text: str, reason: str) -> None:
    with pytest.raises(ParameterValueError, match=reason):
        parse_value(text)


@pytest.mark.parametrize(
    ("pattern", "node", "expected"),
    [
        ("/**", "/a", True),
        ("/**", "/a/b", True),
        ("lidar", "/lidar", True),
        ("lidar", "/robot/lidar", False),
        ("/robot/lidar", "/robot/lidar", True),
        ("/robot/*", "/robot/lidar", True),
        ("/robot/*", "/robot/front/lidar", False),
        ("/**/lidar", "/lidar", True),
        ("/**/lidar", "/a/b/lidar", True),
        ("/*/lidar", "/lidar", False),
        ("/a.c", "/abc", False),
    ],
)
def test_wildcards_stand_for_parts_of_a_name(pattern: str, node: str, expected: bool) -> None:
    assert matches(pattern, node) is expected


def written(folder: Path, text: str) -> str:
    path = folder / "params.yaml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_later_sections_win_and_nesting_becomes_dots(tmp_path: Path) -> None:
    path = written(
        tmp_path,
        """
/**:
  ros__parameters:
    rate: 1.0
    filter: {size: 3, kind: median}
robot:
  lidar:
    ros__parameters:
      filter: {size: 5}
/other:
  ros__parameters:
    rate: 9.0
""",
    )
    assert load(path, "/robot/lidar") == {"rate": 1.0, "filter.size": 5, "filter.kind": "median"}
    assert load(path, "/camera") == {"rate": 1.0, "filter.size": 3, "filter.kind": "median"}


def test_an_empty_file_has_no_parameters(tmp_path: Path) -> None:
    assert load(written(tmp_path, "# nothing yet\n"), "/a") == {}


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("a:\n  ros__parameters:\n    x:1\n", "with a space after ':'"),
        ("a:\n  ros__parameters: 5\n", "with a space after ':'"),
        ("a:\n  x: 5\n", "write the line `ros__parameters:` below `a:`, and indent"),
        ("x: 5\n", "write the line `ros__parameters:` below `/\\*\\*:`"),
        ("a:\n  ros_parameters:\n    x: 5\n", "write ros__parameters in place of ros_parameters$"),
        ("a:\n  ros__parameter:\n    x: 5\n", "in place of ros__parameter$"),
        ("/b/a:\n  ROS__PARAMETERS:\n    x: 5\n", "in place of ROS__PARAMETERS$"),
        ("a:\n  parameters:\n    x: 5\n", "in place of parameters$"),
        ("a:\n\u00a0ros__parameters:\n\u00a0x: 5\n", "U\\+00A0 only looks like a space"),
        ("a:\n  ros__parameters:\n    x： 5\n", "type : in place of ： "),  # noqa: RUF001
        ("just text", "at the top write `name:`"),
        ("ros__parameters:\n  x: 1\n", "write ros__parameters below a node's name"),
        ("a:\n  ros__parameters:\n    x:\n", "line 3: 'x' has no value"),
        ("a:\n  ros__parameters:\n    x: [1, b]\n", "values of a list must have one type"),
        ("a:\n\tros__parameters:\n", "line 2, column 1: found a tab: write spaces"),
        ("a:\n  ros__parameters: &a\n    x: *a\n", "inside its own value"),
        (f"? {'/'.join('a' * 900)}\n: {{ros__parameters: {{x: 1}}}}", "more than 500 characters"),
        (f"a: {{ros__parameters: {{{'x' * 600}: {{y: 1}}}}}}", "line 1: a name has more than 500"),
    ],
)
def test_a_file_with_a_wrong_structure_is_refused_with_the_place(
    tmp_path: Path, text: str, reason: str
) -> None:
    path = written(tmp_path, text)
    with pytest.raises(ParametersFileError, match=reason) as caught:
        load(path, "/a")
    assert caught.value.path == path


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"a: \x00"])
def test_a_file_that_is_not_text_is_rejected(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "params.yaml"
    path.write_bytes(content)
    with pytest.raises(ParametersFileError):
        load(str(path), "/a")


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig", "utf-8"])
def test_a_file_of_a_windows_shell_is_read(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "greeter.yaml"
    path.write_bytes("/greeter:\r\n  ros__parameters:\r\n    name: Zoë\r\n".encode(encoding))
    assert load(str(path), "/greeter") == {"name": "Zoë"}


def test_mappings_of_a_repeated_key_are_merged(tmp_path: Path) -> None:
    text = """\
/**: {ros__parameters: {a: 1, b: 1, filter: {size: 3}, filter: {order: 2}}}
/**: {lidar: {ros__parameters: {b: 2}}}
lab: {lidar: {ros__parameters: {c: 1}}}
lab: {lidar: {ros__parameters: {c: 2, c: 3}}}
"""
    found = load(written(tmp_path, text), "/lab/lidar")
    assert found == {"a": 1, "b": 2, "c": 3, "filter.size": 3, "filter.order": 2}


def test_anchors_are_merged(tmp_path: Path) -> None:
    text = """\
one: &one {ros__parameters: &values {a: 1, b: 1}}
two: *one
three: {ros__parameters: {<<: *values, b: 2}}
"""
    path = written(tmp_path, text)
    assert load(path, "/two") == {"a": 1, "b": 1}
    assert load(path, "/three") == {"a": 1, "b": 2}


def test_values_keep_their_types(tmp_path: Path) -> None:
    text = "/**:\n  ros__parameters: {a: 1, b: 1e3, c: on, d: '1', e: [x, z]}\n"
    expected: dict[str, Any] = {"a": 1, "b": 1000.0, "c": True, "d": "1", "e": ["x", "z"]}
    assert load(written(tmp_path, text), "/n") == expected


@pytest.mark.parametrize("read", [sections, lambda path: load(path, "/a")])
def test_a_missing_file_is_a_file_not_found_error(read: Callable[[str], object]) -> None:
    reason = r"cannot use the parameter file .*no/such\.yaml: No such file"
    with pytest.raises(ParametersFileError, match=reason) as caught:
        read("no/such.yaml")
    assert isinstance(caught.value, FileNotFoundError)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("talkr:\n  ros__parameters:\n    x: 1\n", ["/talkr"]),
        ("/arm/talker:\n  ros__parameters:\n    x: 1\n", ["/arm/talker"]),
        (
            "talkr:\n  ros__parameters:\n    x: 1\nb:\n  ros__parameters:\n    x: 1\n",
            ["/talkr", "/b"],
        ),
        ("talker:\n  ros__parameters:\n    x: 1\n", []),
        ("/**:\n  ros__parameters:\n    x: 1\n", []),
        ("a:\n  ros__parameters:\n    x: 1\nb:\n  ros__parameters:\n    x: 1\n", []),
        ("", []),
    ],
)
def test_a_file_for_a_node_of_another_name_is_noticed(
    tmp_path: Path, text: str, found: list[str]
) -> None:
    assert unused(str(written(tmp_path, text)), "/talker") == found


def test_a_file_that_another_node_uses_is_not_noticed(tmp_path: Path) -> None:
    path = str(written(tmp_path, "listener:\n  ros__parameters:\n    x: 1\n"))
    assert unused(path, "/talker") == ["/listener"]
    assert unused(path, "/listener") == []
    assert unused(path, "/talker") == []
