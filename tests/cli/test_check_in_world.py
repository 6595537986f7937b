"""Tests of `zbot class check --sim`: its mistakes, its marks and its files."""

from __future__ import annotations

import csv
import json
import shutil
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.cli.conftest import Result

    Command = Callable[..., Result]

pytest.importorskip("mujoco", reason="the simulator needs the extra `sim`")
pytest.importorskip("mcap", reason="bags need the extra `bag`")

PROGRAMS = Path(__file__).parents[1] / "programs" / "marking"


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return a folder with a good program and a bad one."""
    folder = tmp_path / "submissions"
    folder.mkdir()
    shutil.copy(PROGRAMS / "ahead.py", folder / "ana.py")
    (folder / "ben.py").write_text("print('no node')\n")
    return folder


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("touches nothing", "--sim", "room"), "--sim and --program need each other"),
        (("touches nothing", "--program", "a.py"), "--sim and --program need each other"),
        (("flies", "--sim", "room", "--program", "."), "cannot check 'flies'"),
        (("touches nothing", "--sim", "rom", "--program", "."), "did you mean 'room'?"),
        (("touches nothing", "--sim", "room", "--program", "no.py"), "there is no file or folder"),
        (("reaches exitt", "--sim", "maze", "--program", "."), "did you mean 'exit'?"),
    ],
)
def test_mistakes_are_told_in_one_sentence(
    zbot_command: Command, submissions: Path, words: tuple[str, ...], said: str
) -> None:
    words = tuple(str(submissions) if word == "." else word for word in words)
    result = zbot_command("class", "check", *words)
    assert result.code == 1
    assert said in result.err


def test_a_folder_is_marked_without_a_class(
    zbot_command: Command, submissions: Path, tmp_path: Path
) -> None:
    output = tmp_path / "marks"
    task = "reaches (0.3, 0) within 5 s and touches nothing"
    words = ("--sim", "room", "--program", str(submissions), "-o", str(output), "--json")
    result = zbot_command("class", "check", task, *words)
    assert result.code == 1
    ana, ben = json.loads(result.out)
    assert (ana["name"], ana["passes"]) == ("ana.py", True)
    assert ben["problems"] == ["the program ended before it made a node"]
    with (output / "marks.csv").open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    assert [row[:2] for row in rows] == [
        ["name", "passes"],
        ["ana.py", "True"],
        ["ben.py", "False"],
    ]
    assert (output / "ben.txt").read_text() == "no node\n"
    assert (output / "ana" / "metadata.yaml").is_file()
