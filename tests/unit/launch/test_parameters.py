from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch import LaunchContext
from zbot.launch.errors import EntityTypeError
from zbot.launch.parameters import ParameterFile, ParameterValue, to_words
from zbot.launch.substitutions import LaunchConfiguration, TextSubstitution
from zbot.parameters import file as parameter_file

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@pytest.fixture
def context() -> Iterator[LaunchContext]:
    made = LaunchContext()
    made.launch_configurations.update({"rate": "2.5", "flag": "true", "name": "bob", "id": "007"})
    yield made
    made.close()


def _read_back(words: list[str]) -> dict[str, Any]:
    assert words[::2] == ["-p"] * (len(words) // 2)
    pairs = [word.partition(":=") for word in words[1::2]]
    return {name: parameter_file.parse_value(text) for name, _, text in pairs}


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (5, 5),
        (2.0, 2.0),
        (True, True),
        ("text", "text"),
        ("5", "5"),
        ("true", "true"),
        ("a: b # c", "a: b # c"),
        ("", ""),
        (" two\nlines ", " two\nlines "),
        ([1, 2], [1, 2]),
        ([1, 2.5], [1.0, 2.5]),
        ((True, False), [True, False]),
        (["a", "b"], ["a", "b"]),
        (float("inf"), float("inf")),
        (LaunchConfiguration("rate"), 2.5),
        (LaunchConfiguration("flag"), True),
        (["robot_", LaunchConfiguration("name")], "robot_bob"),
        (TextSubstitution(text="[1, 2]"), [1, 2]),
        (ParameterValue(LaunchConfiguration("rate"), value_type=str), "2.5"),
        (ParameterValue(LaunchConfiguration("id"), value_type=str), "007"),
        (ParameterValue("3", value_type=str), "3"),
        (ParameterValue(3, value_type=float), 3.0),
        (ParameterValue([1, 2], value_type=list[float]), [1.0, 2.0]),
        (ParameterValue(LaunchConfiguration("flag"), value_type=bool), True),
    ],
)
def test_a_value_reaches_the_node(context: LaunchContext, value: Any, expected: Any) -> None:
    read = _read_back(to_words(context, [{"x": value}]))
    assert read == {"x": expected}
    assert type(read["x"]) is type(expected)


def test_nested_dictionaries_make_names_with_dots(context: LaunchContext) -> None:
    parameters = [{"pid": {"p": 1.0, "limits": {"max": 3}}, LaunchConfiguration("name"): 1}]
    assert _read_back(to_words(context, parameters)) == {
        "pid.p": 1.0,
        "pid.limits.max": 3,
        "bob": 1,
    }


def test_a_long_value_is_passed_in_a_file(context: LaunchContext, tmp_path: Path) -> None:
    text = "<robot>" + "x" * 20_000
    flag, path = to_words(context, [{"robot_description": text}])
    assert flag == "--params-file"
    assert parameter_file.load(path, "/any")["robot_description"] == text
    context.close()
    assert not (tmp_path / path).exists()


def test_files_are_named_and_may_have_substitutions(context: LaunchContext, tmp_path: Path) -> None:
    file = tmp_path / "p.yaml"
    content = {"/**": {"ros__parameters": {"rate": "$(var rate)"}}}
    file.write_text(json.dumps(content).replace('"$', "$").replace(')"', ")"), encoding="utf-8")
    assert to_words(context, [str(file), file]) == ["--params-file", str(file)] * 2
    flag, path = to_words(context, [ParameterFile(file, allow_substs=True)])
    assert flag == "--params-file"
    assert parameter_file.load(path, "/any") == {"rate": 2.5}


def test_a_missing_file_is_an_error(
    context: LaunchContext, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert to_words(context, [str(tmp_path / "missing.yaml")]) == []
    assert "Parameter file path is not a file" in capsys.readouterr().out


@pytest.mark.parametrize("value", [None, object(), {"x": object()}])
def test_an_invalid_parameter_is_refused(context: LaunchContext, value: Any) -> None:
    with pytest.raises(EntityTypeError):
        to_words(context, [value if isinstance(value, dict) else {"x": value}])
