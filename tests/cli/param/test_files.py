"""Tests of parameter files, which `zbot param` dumps and loads."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import pytest

from tests.cli.param.conftest import SERVICE
from zbot.parameters.file import sections
from zbot.parameters.parameter import Parameter
from zbot_cli.output.parameter_text import file_text, values_for

if TYPE_CHECKING:
    from pathlib import Path

    import zbot as library
    from tests.cli.conftest import Command
    from tests.conftest import Start


def test_load_restores_what_dump_wrote(
    zbot_command: Command, rich: library.Node, tmp_path: Path
) -> None:
    before = {
        name: parameter.value for name, parameter in rich.get_parameters_by_prefix("").items()
    }
    path = tmp_path / "rich.yaml"
    path.write_text(zbot_command("param", "dump", "/lab/rich").out)
    changed = {
        "level": 5,
        "group": "x",
        "group.flags": [],
        "group.numbers": [9],
        "group.gains": [9.0],
        "group.words": ["x"],
        "group.bytes": [b"x"],
    }
    results = rich.set_parameters([Parameter(name, value=value) for name, value in changed.items()])
    assert all(answer.successful for answer in results)
    result = zbot_command("param", "load", "/lab/rich", str(path))
    assert {
        name: parameter.value for name, parameter in rich.get_parameters_by_prefix("").items()
    } == before
    assert result.code == 0, "what is read-only and unchanged is no failure"
    assert "Set parameter level successful\n" in result.out
    assert result.err == (
        "Set parameter share failed: Trying to set a read-only parameter: share.\n"
        "Set parameter start_type_description_service failed: "
        "Trying to set a read-only parameter: start_type_description_service.\n"
    )


FILE = """
/**:
  ros__parameters: {rate: 1.5, my_parameter: general}
/minimal_service:
  ros__parameters: {my_parameter: own}
/lab/*:
  ros__parameters: {level: 5}
"""


@pytest.mark.usefixtures("rich")
def test_load_selects_the_sections_of_the_node(
    zbot_command: Command, node: library.Node, tmp_path: Path
) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(FILE)
    result = zbot_command("param", "load", SERVICE, str(path))
    assert result.out == "Set parameter rate successful\nSet parameter my_parameter successful\n"
    assert node.get_parameter("my_parameter").value == "own"
    result = zbot_command("param", "load", SERVICE, str(path), "--no-use-wildcard")
    assert result.out == "Set parameter my_parameter successful\n"
    result = zbot_command("param", "load", str(path))
    assert result.code == 1, "/lab/rich has no rate"
    assert "/lab/rich:\n" in result.out
    assert "  Set parameter level successful\n" in result.out
    assert "  Set parameter rate failed: Invalid access to undeclared" in result.err


@pytest.mark.usefixtures("node")
@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (None, "cannot use the parameter file .*: No such file"),
        ("/other:\n  ros__parameters: {a: 1}", "any valid parameters for /minimal_service"),
        ("/minimal_service: {a: 1}", "cannot use the parameter file"),
    ],
)
def test_a_useless_file_is_refused(
    zbot_command: Command, tmp_path: Path, text: str | None, sentence: str
) -> None:
    path = tmp_path / "p.yaml"
    if text is not None:
        path.write_text(text)
    result = zbot_command("param", "load", SERVICE, str(path))
    assert (result.code, result.out) == (1, "")
    assert re.search(sentence, result.err)


@pytest.mark.parametrize(
    "value",
    [
        "plain",
        "1e3",
        "08",
        "0x1F",
        "yes",
        "~",
        "a: b",
        "- a",
        "#",
        " x ",
        "two\nlines",
        "🤖",
        "'",
        "[",
    ],
)
def test_every_text_survives_a_file(value: str, tmp_path: Path) -> None:
    parameters: dict[str, Parameter[Any]] = {
        "one": Parameter("one", value=value),
        "many": Parameter("many", value=[value, value]),
    }
    path = tmp_path / "p.yaml"
    path.write_text(file_text({"/n": parameters}), encoding="utf-8")
    found = values_for(sections(str(path)), "/n", use_wildcards=True)
    assert found == {"one": value, "many": [value, value]}


def test_a_missing_parameter_file_is_refused_with_one_sentence(start: Start) -> None:
    program = start("zbot", "run", "talker", "--ros-args", "--params-file", "nowhere.yaml")
    assert program.wait() == 1
    assert program.lines == [
        "cannot use the parameter file nowhere.yaml: No such file or directory"
    ]
