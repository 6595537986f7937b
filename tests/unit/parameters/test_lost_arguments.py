"""Tests for the warning about arguments without `--ros-args`."""

from __future__ import annotations

import pytest

from zbot.context import Context
from zbot.parameters.lost_arguments import warning_about


@pytest.mark.parametrize(
    ("words", "right"),
    [
        ("chatter:=/news", "-r chatter:=/news"),
        ("__node:=other", "-r __node:=other"),
        ("__ns:=/robot", "-r __ns:=/robot"),
        ("_rate:=2.0", "-p rate:=2.0"),
        ("rate:=2.0", "-p rate:=2.0"),
        ("on:=true", "-p on:=true"),
        ("__params:=a.yaml", "--params-file a.yaml"),
        ("__log_level:=debug", "--log-level debug"),
        ("-r chatter:=/news", "-r chatter:=/news"),
        ("-p rate:=2.0 -p name:=x", "-p rate:=2.0 -p name:=x"),
        ("--remap a:=b", "--remap a:=b"),
        ("--params-file a.yaml", "--params-file a.yaml"),
    ],
)
def test_an_argument_without_ros_args_is_shown_with_them(words: str, right: str) -> None:
    said = warning_about(["program.py", *words.split()])
    assert said == f"'{words}' has no effect; write --ros-args {right}"


def test_several_arguments_make_one_sentence() -> None:
    said = warning_about(["program.py", "a:=/b", "file.txt", "_rate:=2"])
    assert said == "'a:=/b _rate:=2' has no effect; write --ros-args -r a:=/b -p rate:=2"


@pytest.mark.parametrize("word", ["--ros-arg", "--ros_args", "-ros-args", "--rosargs"])
def test_a_misspelt_ros_args_is_named(word: str) -> None:
    assert warning_about(["a.py", word]) == f"{word} has no effect; did you mean '--ros-args'?"


@pytest.mark.parametrize(
    "words", ["", "a.py", "a.py file.txt --port /dev/tty -r 5", "a.py x=1 C:\\dir:=", "a.py -p 80"]
)
def test_other_arguments_are_the_programs_own(words: str) -> None:
    assert warning_about(words.split()) == ""


def test_init_warns(capsys: pytest.CaptureFixture[str]) -> None:
    Context().init(["talker.py", "__node:=x"])
    assert "'__node:=x' has no effect; write --ros-args -r __node:=x" in capsys.readouterr().err
