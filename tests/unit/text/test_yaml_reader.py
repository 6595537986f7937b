from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot  # noqa: F401 - makes the messages importable
from tests.conftest import allowed
from zbot.interfaces.content_filter import ContentFilter, ContentFilterError
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.interfaces.spec import FieldType
from zbot.launch.errors import (
    CoercionError,
    InvalidFrontendLaunchFileError,
    SubstitutionSyntaxError,
)
from zbot.launch.frontend import substitution_text, xml_file, yaml_file
from zbot.launch.typed_value import coerce_to_type
from zbot.parameters.errors import ParametersFileError, ParameterValueError
from zbot.parameters.file import parse_value, sections
from zbot.text.yaml_reader import (
    YamlError,
    compose_untagged,
    compose_yaml,
    construct_yaml,
    read_yaml,
)
from zbot.web.forms.form_value import DURATION, read
from zbot_cli.input.message_values import PopulateError, Template, ValuesError

from geometry_msgs.msg import Twist
from std_msgs.msg import Float64, Int64, String

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

DEEP = {
    "brackets": "[" * 30_000,
    "braces": "{a: " * 30_000,
    "lines": "\n".join(" " * depth + "a:" for depth in range(1500)),
    "dashes": "- " * 30_000,
}
ALIASES = "a0: &a0 [x, x]\n" + "".join(
    f"a{i}: &a{i} [*a{i - 1}, *a{i - 1}]\n" for i in range(1, 40)
)
BAD = {
    **DEEP,
    "aliases": ALIASES,
    "merges": "a0: &a0 {x: 1}\n"
    + "".join(f"a{i}: &a{i} [*a{i - 1}, *a{i - 1}, {{<<: *a0}}]\n" for i in range(1, 40)),
    "chained aliases": "a0: &a0 [x]\n"
    + "".join(f"a{i}: &a{i} [*a{i - 1}]\n" for i in range(1, 200)),
    "long aliases": f"a: &a [{'x, ' * 9000}]\nb: [{'*a, ' * 20}]\n",
    "self": "&a [*a]",
    "self key": "&a {*a : 1}",
    "int": "!!int x",
    "empty int": '!!int ""',
    "bool": "!!bool x",
    "float": "!!float x",
    "date": "!!timestamp x",
    "month": "2024-13-01",
    "digits": "9" * 5000,
    "hexadecimal digits": "0x" + "f" * 5000,
    "binary digits": "0b" + "1" * 20_000,
    "base 60": "1" + ":59" * 5000,
    "base 60 with a space": f"!!int ' 1{':59' * 20_000}'",
    "tag": "!!python/object:os.system x",
    "binary": "!!binary 'a'",
    "key": "{[]: 1}",
    "surrogate": "'\ud800'",
    "control": "'\x00'",
    "documents": "a\n---\nb",
}


@pytest.fixture(autouse=True)
def quick() -> Iterator[None]:
    begin = time.process_time()
    yield
    assert time.process_time() - begin < allowed(5)  # most take less than 10 ms


@pytest.mark.parametrize("name", BAD)
def test_yaml_that_cannot_be_read_is_one_error(name: str) -> None:
    with pytest.raises(YamlError):
        read_yaml(BAD[name])
    with pytest.raises(YamlError):
        construct_yaml(compose_yaml(BAD[name]))


@pytest.mark.parametrize("read", [compose_untagged, lambda text: read_yaml(text, as_strings=True)])
def test_other_ways_to_read_are_safe_from_deep_text_too(read: Callable[[str], object]) -> None:
    for text in DEEP.values():
        with pytest.raises(YamlError, match=r"line \d+, column \d+: it is nested deeper than 100"):
            read(text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("{header:{frame_id: x}, axes:[0.0]}", {"header": {"frame_id": "x"}, "axes": [0.0]}),
        ('{"a":1,"b":[1,2]}', {"a": 1, "b": [1, 2]}),
        ("a:\t1\t# comment", {"a": 1}),
        ("[1,\t2]", [1, 2]),
        ("a\tb", "a\tb"),
        ("\ufeffa: 1", {"a": 1}),
    ],
)
def test_what_one_of_the_two_parsers_accepts_is_read(text: str, expected: object) -> None:
    assert read_yaml(text) == expected


def test_every_scalar_can_stay_a_string() -> None:
    found = read_yaml("[no, 1e3, ~, 2020-01-01, {on: [1]}]", as_strings=True)
    assert found == ["no", "1e3", "~", "2020-01-01", {"on": ["1"]}]


def test_the_error_has_the_place() -> None:
    with pytest.raises(YamlError) as caught:
        read_yaml("a: 1\nb: [")
    assert (caught.value.line, str(caught.value)[:6]) == (1, "line 2")


def test_a_long_text_that_is_no_yaml_is_refused_quickly() -> None:
    begin = time.process_time()
    with pytest.raises(YamlError, match=r"line 1, column \d+: "):
        read_yaml("[" + "1," * 200_000 + "}")
    with pytest.raises(YamlError, match="needs a colon at its end"):
        read_yaml("a: b\n" * 20_000 + "b: c: d")
    assert time.process_time() - begin < allowed(3)


def test_yaml_within_the_limits_is_read() -> None:
    assert read_yaml("") is None
    assert read_yaml("[" * 100 + "]" * 100)
    assert read_yaml("a: &a [1, 2]\nb: *a\nc: {<<: {d: 5}}") == {
        "a": [1, 2],
        "b": [1, 2],
        "c": {"d": 5},
    }
    assert len(read_yaml(str(list(range(20_000))))) == 20_000


# -- the places where zbot reads YAML and other texts of users -----------------------------------


@pytest.mark.parametrize("name", BAD)
def test_values_of_users_are_refused(tmp_path: Path, name: str) -> None:
    text = BAD[name]
    # Parameters have no types of YAML, except `!!str`.
    if name not in {"month", "bool", "float", "int", "date", "tag", "binary"}:
        if name != "empty int":
            with pytest.raises(ParameterValueError):
                parse_value(text)
        if name not in {"surrogate", "control", "empty int"}:
            path = tmp_path / "parameters.yaml"
            lines = f"/**:\n  ros__parameters:\n    a: {text}\n" if "\n" not in text else text
            path.write_text(lines)
            with pytest.raises(ParametersFileError):
                sections(str(path))
    with pytest.raises((ValuesError, PopulateError)):
        Template(Int64, f"{{data: {text}}}")
    with pytest.raises(FieldMisfitError):
        read(FieldType("int64", "sequence"), text, "a", lambda: 0)
    with pytest.raises(CoercionError):
        coerce_to_type(text, int)
    if name == "key":
        return  # a launch file may have a tag of any name
    with pytest.raises(InvalidFrontendLaunchFileError):
        yaml_file.parse(f"launch:\n- arg: {{name: {text}}}" if "\n" not in text else text, "a.yaml")


@pytest.mark.parametrize(
    ("kind", "entry"),
    [
        (DURATION, "-.inf"),
        (DURATION, ".nan"),
        (DURATION, "1e999999"),
        (DURATION, "-1e99"),
        ("float64", "1e999999"),
        ("float32", "-1e999999"),
        ("int64", "1e999999"),
        ("int64", "-.inf"),
        ("int64", "9" * 5000),
        ("bool", "1e999999"),
        ("string", "\ud800"),
    ],
)
def test_odd_numbers_in_a_form_are_refused(kind: str, entry: str) -> None:
    with pytest.raises(FieldMisfitError):
        read(FieldType(kind), entry, "a", lambda: 0)


def test_infinities_in_a_form_are_written_as_words() -> None:
    assert read(FieldType("float64"), "-.inf", "a", lambda: 0) == float("-inf")
    assert read(FieldType(DURATION), "1.5", "a", lambda: 0).nanosec == 500_000_000


@pytest.mark.parametrize(
    "expression",
    [
        "(" * 30_000 + "data = 1",
        "NOT " * 30_000 + "data = 1",
        "data = 1" + " AND data = 1" * 50_000,
        "(" * 60 + "data = 1" + ")" * 60,
        "NOT " * 60 + "data = 1",
        "data = " + "9" * 5000,
        "data = \ud800",
        "data.a.a.a[99999999999999999999] = 1",
        " " * 100_000 + "#",
    ],
)
def test_a_content_filter_that_is_too_large_is_refused(expression: str) -> None:
    with pytest.raises(ContentFilterError) as caught:
        ContentFilter(expression, (), Float64)
    assert len(str(caught.value)) < 1000


def test_a_long_content_filter_is_evaluated() -> None:
    condition = ContentFilter("data=1" + " AND data=1" * 800 + " OR data=2", (), Float64)
    assert condition.matches(Float64(data=1.0))
    assert condition.matches(Float64(data=2.0))
    assert not condition.matches(Float64(data=3.0))
    assert ContentFilter("(" * 40 + "data=1" + ")" * 40, (), Float64).matches(Float64(data=1.0))


def test_deep_launch_files_are_refused() -> None:
    with pytest.raises(InvalidFrontendLaunchFileError, match="deeper than 100 levels"):
        xml_file.parse("<launch>" + "<group>" * 3000 + "</group>" * 3000 + "</launch>", "a.xml")
    lines = ["launch:"]
    lines.extend("  " * depth + "- group:" for depth in range(3000))
    with pytest.raises(InvalidFrontendLaunchFileError, match="deeper than 100 levels"):
        yaml_file.parse("\n".join(lines), "a.yaml")
    with pytest.raises(InvalidFrontendLaunchFileError, match="must not define entities"):
        xml_file.parse('<!DOCTYPE a [<!ENTITY x "y">]><launch>&x;</launch>', "a.xml")
    with pytest.raises(InvalidFrontendLaunchFileError, match="must not define attributes"):
        xml_file.parse('<!DOCTYPE a [<!ATTLIST x y CDATA "z">]><launch><x/></launch>', "a.xml")
    with pytest.raises(InvalidFrontendLaunchFileError, match="encoding cannot be read"):
        xml_file.parse(b'<?xml version="1.0" encoding="foo"?><launch/>', "a.xml")


def test_deep_substitutions_are_refused() -> None:
    with pytest.raises(SubstitutionSyntaxError, match="deeper than 50 levels"):
        substitution_text.parse("$(var " * 3000)


def test_deep_assignments_are_refused() -> None:
    values: Any = ".".join(["linear"] * 3000) + "=1"
    with pytest.raises((ValuesError, PopulateError)):
        Template(Twist, values)
    with pytest.raises(ValuesError, match="deeper than 100 levels"):
        Template(String, "data" + ".a" * 3000 + "=1")
