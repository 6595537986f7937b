"""Tests of names that launch_testing's own tests use."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

import pytest

import zbot.compat
from zbot.launch.action import Action
from zbot.launch.actions.execute import ExecuteProcess
from zbot.launch.substitutions import LocalSubstitution
from zbot.launch.testing.assertion import SequentialTextChecker
from zbot.launch.testing.error import NoMatchingProcessError
from zbot.launch.testing.expected_output import expected_output_from_file
from zbot.launch.testing.process_lookup import resolve_processes
from zbot.launch.testing.ready_listener import StdoutReadyListener
from zbot.launch.testing.record import ExitRecord, OutputRecord

if TYPE_CHECKING:
    from pathlib import Path


@pytest.mark.parametrize(
    ("found", "near"),
    [
        ([], "one\ntwo\nthree"),
        (["on"], "one\ntwo\nthree"),
        (["one"], "one\ntwo\nthree\nfour"),
        (["three"], "two\nthree\nfour\nfive"),
        (["five"], "three\nfour\nfive"),
    ],
)
def test_a_missing_text_is_reported_with_the_nearby_lines(found: list[str], near: str) -> None:
    checker = SequentialTextChecker(["one\ntwo\n", "three\nfour\n", "five\n"])
    for text in found:
        checker.assertInStdout(text)
    with pytest.raises(AssertionError) as caught:
        checker.assertInStdout("six")
    assert str(caught.value).endswith(f":\n{near}")
    assert checker.get_nearby_lines() == near


@pytest.mark.parametrize(
    ("words", "expected"),
    [(["python", "-c", ""], "python -c"), ([LocalSubstitution("x"), "y"], "Unknown")],
)
def test_a_process_that_never_started_is_named(words: list[str], expected: str) -> None:
    with pytest.raises(
        NoMatchingProcessError, match=f"Did not find any process matching {expected}"
    ):
        resolve_processes(ExitRecord(), process=ExecuteProcess(cmd=words))


def test_a_listener_describes_itself_and_its_actions() -> None:
    action = Action()
    text, actions = StdoutReadyListener(ready_txt="ready", actions=[action]).describe()
    assert "ready" in text
    assert actions == [action]


def test_a_file_of_expected_lines_may_be_escaped(tmp_path: Path) -> None:
    (tmp_path / "lines.txt").write_text("a\\tb\n")
    path = str(tmp_path / "lines")
    assert expected_output_from_file(path) == ["a\\tb"]
    assert expected_output_from_file(path, encoding="unicode_escape") == ["a\tb"]


def test_the_records_have_launch_testings_names() -> None:
    zbot.compat.install_names()
    module = importlib.import_module("launch_testing")
    assert (module.ActiveIoHandler, module.ProcInfoHandler) == (OutputRecord, ExitRecord)
    record = module.IoHandler()
    record.track("talker-1")
    assert record.processes() == []
