from __future__ import annotations

import json
import math
import sys
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from zbot.launch import LaunchContext
from zbot.launch.errors import CoercionError, EntityTypeError
from zbot.launch.parameters import (
    Parameter,
    ParameterFile,
    ParameterValue,
    normalize_parameters,
    to_words,
)
from zbot.launch.substitutions import Command, LaunchConfiguration, TextSubstitution
from zbot.parameters import file as parameter_file
from zbot.parameters.ros_args import Arguments

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


URDF = '<robot name="r"><!-- wheel: left --><link name="base"/></robot>'
TEXTS = [
    *(URDF, '{"a": 1, "b": [1]}', "#c", "a #c", "*a", "[a", "[a]", "{a: 1}", "%x", "@x", "`x"),
    *(
        "a\tb",
        "\ta",
        "a\nb",
        "a\n b\n\n",
        "a\r\nb",
        "\n",
        "",
        " ",
        " a ",
        "é 日本 😀",
        "---",
        "a\n---\nb",
    ),
    *(
        "ends:",
        "a: b: c",
        "!tag",
        "!tag x",
        "&a b",
        "? a",
        "- 1\n- 2",
        "|",
        ">",
        "'",
        '"',
        "'a'",
        "}",
    ),
    *(
        "null",
        "~",
        "true",
        "y",
        "on",
        "1",
        "1.10",
        "1e3",
        "08",
        "0x10",
        "1_000",
        "1:30",
        "2020-01-01",
    ),
    *(
        "nan",
        ".inf",
        "=",
        "<<",
        "\x01",
        "\x7f",
        "\x85",
        "a\u2028b",
        "\ufeff",
        "C:\\x",
        "${x}",
        "5 ",
    ),
]


@pytest.mark.parametrize("text", TEXTS)
def test_a_text_with_the_type_str_reaches_the_node_unchanged(
    context: LaunchContext, text: str
) -> None:
    given = TextSubstitution(text=text)
    values = [
        {"x": ParameterValue(given, value_type=str)},
        {"x": ParameterValue(text, value_type=str)},
        {"x": text},
        Parameter("x", given, value_type=str),
    ]
    for value in values:
        assert _read_back(to_words(context, [value])) == {"x": text}


def test_a_list_of_texts_reaches_the_node_unchanged(context: LaunchContext) -> None:
    assert _read_back(to_words(context, [{"x": TEXTS}])) == {"x": TEXTS}


@pytest.mark.parametrize(
    ("text", "kind", "expected"),
    [
        ("010", int, 10),
        ("1_000", int, 1000),
        ("5", float, 5.0),
        ("nan", float, math.nan),
        (".inf", float, math.inf),
        ("-inf", float, -math.inf),
        ("1", bool, True),
        ("off", bool, False),
        ("[08, 1.10, true, y]", list[str], ["08", "1.10", "true", "y"]),
        ("[1, 2]", list[float], [1.0, 2.0]),
        ("[.nan, .inf, 1e3]", list[float], [math.nan, math.inf, 1000.0]),
        ("[1, 010]", list[int], [1, 10]),
        ("[on, false]", list[bool], [True, False]),
        ("[]", list[int], []),
        ("1_000", None, 1000),
        ("1:30", None, 90),
        ("0b1", None, 1),
        ("1e3", None, 1000.0),
        ("nan", None, math.nan),
        ("y", None, True),
        ("'y'", None, "y"),
        ("!!str 5", None, "5"),
        ("[.inf, nan]", None, [math.inf, math.nan]),
        ("2020-01-01", None, "2020-01-01"),
    ],
)
def test_the_type_decides_how_a_text_is_read(
    context: LaunchContext, text: str, kind: Any, expected: Any
) -> None:
    value = ParameterValue(TextSubstitution(text=text), value_type=kind)
    assert repr(_read_back(to_words(context, [{"x": value}]))["x"]) == repr(expected)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("1.5", int),
        ("fast", int),
        ("fast", float),
        ("[1]", float),
        ("y", bool),
        ("5", list[str]),
        ("[a", list[str]),
        ("[[a]]", list[str]),
        ("[1.5]", list[int]),
    ],
)
def test_a_text_that_has_not_the_type_is_refused(
    context: LaunchContext, text: str, kind: Any
) -> None:
    value = ParameterValue(TextSubstitution(text=text), value_type=kind)
    with pytest.raises(CoercionError, match="is not a value of type"):
        to_words(context, [{"x": value}])


@pytest.mark.parametrize("text", [URDF, '{"a": 1}', "[a", "[1, a]", "*a"])
def test_a_text_that_is_not_yaml_needs_the_type(context: LaunchContext, text: str) -> None:
    with pytest.raises(EntityTypeError) as caught:
        to_words(context, [{"x": TextSubstitution(text=text)}])
    assert "value_type=str" in caught.value.hint or "of one kind" in str(caught.value)


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ([math.inf, -math.inf], [math.inf, -math.inf]),
        ([math.nan], [math.nan]),
        ([1, math.inf], [1.0, math.inf]),
        (np.float32(1.5), 1.5),
        (np.int64(3), 3),
        (np.array([1.0, math.inf]), [1.0, math.inf]),
        (ParameterValue(np.array([1, 2]), value_type=list[float]), [1.0, 2.0]),
    ],
)
def test_numbers_of_any_kind_reach_the_node(
    context: LaunchContext, value: Any, expected: Any
) -> None:
    read = _read_back(to_words(context, normalize_parameters([{"x": value}])))
    assert repr(read["x"]) == repr(expected)


@pytest.mark.parametrize("name", ["on", "01", "1.10", "a b", "a:b", "a:=b", "null", "~", "=", "é"])
def test_the_name_of_a_parameter_stays_as_it_is(context: LaunchContext, name: str) -> None:
    arguments = Arguments.parse(["program", "--ros-args", *to_words(context, [{name: 1}])])
    assert arguments.parameters_for("/any") == {name: 1}


def test_a_command_with_a_type_runs_once(context: LaunchContext, tmp_path: Path) -> None:
    script = "import sys; open(sys.argv[1], 'a').write('x'); print('a: b')"
    log = tmp_path / "log"
    command = Command([sys.executable, " -c ", f'"{script}"', " ", str(log)])
    value = ParameterValue(command, value_type=str)
    assert _read_back(to_words(context, [{"x": value}]))["x"].strip() == "a: b"
    assert log.read_text() == "x"


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
