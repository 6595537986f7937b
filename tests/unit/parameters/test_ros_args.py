from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import pytest

from zbot.parameters.errors import ArgumentsError, ParametersFileError
from zbot.parameters.ros_args import Arguments, LogLevel, ParametersFile, Remap, remove_ros_args

if TYPE_CHECKING:
    from pathlib import Path


def parse(*words: str) -> Arguments:
    return Arguments.parse(["prog", "--ros-args", *words])


def test_a_command_line_without_ros_args_changes_nothing() -> None:
    arguments = Arguments.parse(["prog", "-r", "a:=b", "--"])
    assert arguments == Arguments(unparsed=("prog", "-r", "a:=b", "--"))
    assert arguments.node_name_for("talker") == "talker"
    assert arguments.namespace_for("talker") is None
    assert arguments.remapped("/chatter", "talker", "/", is_service=False) == "/chatter"
    assert arguments.parameters_for("/talker") == {}


def test_ros_args_end_at_two_dashes_and_may_come_again() -> None:
    line = ["prog", "1", "--ros-args", "-r", "a:=b", "--", "--mine", "--ros-args", "-r", "c:=d"]
    arguments = Arguments.parse(line)
    assert [rule.source for rule in arguments.remaps] == ["a", "c"]
    assert arguments.unparsed == ("prog", "1", "--mine")
    assert remove_ros_args(line) == ["prog", "1", "--mine"]


def test_remove_ros_args_takes_the_process_arguments(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["prog", "--ros-args", "-r", "a:=b"])
    assert remove_ros_args() == ["prog"]


@pytest.mark.parametrize("flag", ["-r", "--remap"])
def test_remap_rules_are_read(flag: str) -> None:
    arguments = parse(flag, "talker:chatter:=/news", flag, "rosservice://add:=~/add")
    assert arguments.remaps == (
        Remap("chatter", "/news", "talker"),
        Remap("add", "~/add", kind="service"),
    )


@pytest.mark.parametrize(
    ("rule", "full_name", "expected"),
    [
        ("chatter:=news", "/ns/chatter", "/ns/news"),
        ("chatter:=/news", "/ns/chatter", "/news"),
        ("chatter:=news", "/chatter", "/chatter"),
        ("/chatter:=/news", "/chatter", "/news"),
        ("~/state:=status", "/ns/talker/state", "/ns/status"),
        ("chatter:=~/news", "/ns/chatter", "/ns/talker/news"),
        ("{node}/x:=y", "/ns/talker/x", "/ns/y"),
        ("talker:chatter:=news", "/ns/chatter", "/ns/news"),
        ("other:chatter:=news", "/ns/chatter", "/ns/chatter"),
        ("rostopic://chatter:=news", "/ns/chatter", "/ns/news"),
        ("rosservice://chatter:=news", "/ns/chatter", "/ns/chatter"),
        ("talker:rostopic://chatter:=news", "/ns/chatter", "/ns/news"),
        ("__node:=x", "/ns/__node", "/ns/__node"),
    ],
)
def test_topics_are_remapped(rule: str, full_name: str, expected: str) -> None:
    assert parse("-r", rule).remapped(full_name, "talker", "/ns", is_service=False) == expected


def test_services_have_rules_of_their_own() -> None:
    arguments = parse("-r", "rosservice://add:=plus", "-r", "rostopic://add:=sum")
    assert arguments.remapped("/add", "n", "/", is_service=True) == "/plus"
    assert arguments.remapped("/add", "n", "/", is_service=False) == "/sum"


def test_the_first_matching_rule_wins() -> None:
    arguments = parse("-r", "a:=b", "-r", "a:=c", "-r", "b:=d")
    assert arguments.remapped("/a", "n", "/", is_service=False) == "/b"


def test_node_and_namespace_are_renamed() -> None:
    arguments = parse("-r", "__node:=sensor_2", "-r", "__ns:=/lab")
    assert arguments.node_name_for("sensor") == "sensor_2"
    assert arguments.namespace_for("sensor") == "/lab"
    assert parse("-r", "__name:=x").node_name_for("sensor") == "x"


def test_one_node_of_several_is_renamed() -> None:
    arguments = parse("-r", "left:__node:=right", "-r", "left:__ns:=/lab")
    assert (arguments.node_name_for("left"), arguments.node_name_for("up")) == ("right", "up")
    assert (arguments.namespace_for("left"), arguments.namespace_for("up")) == ("/lab", None)


@pytest.mark.parametrize("flag", ["-p", "--param"])
def test_parameters_are_read_as_yaml(flag: str) -> None:
    arguments = parse(flag, "rate:=1.5", flag, "talker:name:=a b", flag, "ids:=[1, 2]")
    assert arguments.parameters_for("/ns/talker") == {"rate": 1.5, "name": "a b", "ids": [1, 2]}
    assert arguments.parameters_for("/ns/other") == {"rate": 1.5, "ids": [1, 2]}


def test_the_last_value_of_a_parameter_wins_also_against_files(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/**:\n  ros__parameters: {a: 1, b: 1}\n")
    arguments = parse("-p", "a:=0", "--params-file", str(path), "-p", "b:=2")
    assert arguments.parameters[1] == ParametersFile(str(path))
    assert arguments.parameters_for("/n") == {"a": 1, "b": 2}


def test_a_bad_parameter_file_is_reported_when_it_is_used() -> None:
    arguments = parse("--params-file", "no/such/file.yaml")
    with pytest.raises(ParametersFileError, match=r"no/such/file\.yaml"):
        arguments.parameters_for("/n")


def test_log_options_are_read() -> None:
    arguments = parse(
        *("--log-level", "debug", "--log-level", "my.node:=WARN", "--disable-rosout-logs"),
        *("--log-config-file", "c", "--log-file-name", "f", "--enable-external-lib-logs"),
        *("--disable-stdout-logs", "--enclave", "/lab/a"),
    )
    assert arguments.log_levels == (LogLevel("debug"), LogLevel("warn", "my.node"))
    assert arguments.log_file_name == "f"
    assert (arguments.rosout_logs, arguments.stdout_logs) == (False, False)
    assert arguments.external_lib_logs
    assert arguments.enclave == "/lab/a"


def test_arguments_of_a_node_come_before_those_of_the_process() -> None:
    own, process = (
        parse("-r", "a:=own", "-p", "x:=1"),
        parse("-r", "a:=b", "-p", "x:=2", "-e", "/e"),
    )
    merged = own.merged(process)
    assert merged.remapped("/a", "n", "/", is_service=False) == "/own"
    assert merged.parameters_for("/n") == {"x": 1}
    assert merged.enclave == "/e"


@pytest.mark.parametrize(
    ("words", "bad", "reason"),
    [
        (["--remp", "a:=b"], ["--remp", "a:=b"], "unknown flag: use -r"),
        (["chatter:=news", "-r", "a:=b"], ["chatter:=news"], "unknown flag: use -r"),
        (["-r"], "-r", "needs a value"),
        (["-r", "chatter"], "chatter", "':=' is missing: write it as in `-r chatter:=/news`"),
        (["-r", "chatter:="], "chatter:=", "no value after"),
        (["-r", ":=news"], ":=news", "no name before"),
        (["-r", "a b:=news"], "a b:=news", "must not contain"),
        (["-r", "a:=new s"], "a:=new s", "must not contain"),
        (["-r", "__ns:=lab"], "__ns:=lab", "must be absolute"),
        (["-r", "__node:=a/b"], "__node:=a/b", "Invalid node name"),
        (["-p", "rate=1"], "rate=1", "`-p speed:=1.5`"),
        (["-p", "rate:=[1"], "rate:=[1", "line 1"),
        (["-p", "rate:=[1, x]"], "rate:=[1, x]", "must have one type"),
        (["--log-level", "loud"], "loud", "one of the levels unset, debug"),
        (["--log-level", "node:=loud"], "node:=loud", "one of the levels unset, debug"),
        (["--log-level", ":=info"], ":=info", "one of the levels unset, debug"),
    ],
)
def test_an_invalid_word_gets_a_hint(words: list[str], bad: str | list[str], reason: str) -> None:
    with pytest.raises(ArgumentsError) as caught:
        parse(*words)
    assert caught.value.word == bad
    assert str(caught.value).startswith(f"Failed to parse ROS arguments: {bad!r}: ")
    assert reason in str(caught.value)


@pytest.mark.parametrize(
    ("words", "right"),
    [
        (["–-ros-args", "-p", "a:=1"], "--ros-args"),  # noqa: RUF001 - the dash of a word processor
        (["—ros-args", "-p", "a:=1"], "--ros-args"),
        (["--ros-args", "–p", "a:=1"], "-p"),  # noqa: RUF001 - as above
    ],
)
def test_the_dash_of_a_word_processor_is_named(words: list[str], right: str) -> None:
    with pytest.raises(ArgumentsError, match=f": type {right} in place of "):
        Arguments.parse(words)


def test_other_words_with_such_a_dash_belong_to_the_program() -> None:
    assert Arguments.parse(["–", "–v", "-ros-args"]).unparsed == ("–", "–v", "-ros-args")  # noqa: RUF001 - as above
