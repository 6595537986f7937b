"""Test files of courses, run by `zbot test` and by pytest as processes of their own."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program

    Start = Callable[..., Program]

HERE = Path(__file__).parent / "launch_tests"
PYTEST = (sys.executable, "-m", "pytest", "-p", "zbot.compat.pytest_plugin", "-p",
          "no:cacheprovider", "-rA", "--rootdir", "/")  # fmt: skip
PATIENCE_S = 60
BEGINNING = """
import sys, unittest
import launch, launch_testing.actions

def generate_test_description():
    run = launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", "{program}"])
    return launch.LaunchDescription([run, {ready}])

class TestNumbers(unittest.TestCase):
    def test_a_number(self, test_args):
        self.assertEqual(test_args.get("number", "3"), "3")
"""
WAITING = "import threading; threading.Event().wait()"
READY = "launch_testing.actions.ReadyToTest()"


def written(folder: Path, *, program: str = WAITING, ready: str = READY) -> str:
    path = folder / "numbers_launch.py"
    path.write_text(BEGINNING.format(program=program, ready=ready), encoding="utf-8")
    return str(path)


def test_a_course_s_test_runs_with_zbot_test(start: Start) -> None:
    program = start("zbot", "test", str(HERE / "talker_listener.py"))
    assert program.wait(PATIENCE_S) == 0, program.output
    assert "Ran 5 tests" in program.output
    assert "Ran 2 tests" in program.output


@pytest.mark.parametrize(
    ("file", "told"),
    [
        pytest.param("talker_listener.py", "1 passed", id="a course's test"),
        pytest.param("pytest_style.py", "7 passed", id="launches are fixtures"),
        pytest.param("pytest_stages.py", "13 passed", id="the end of a shared launch comes last"),
    ],
)
def test_launch_tests_run_under_pytest(start: Start, file: str, told: str) -> None:
    program = start(*PYTEST, str(HERE / file))
    assert program.wait(PATIENCE_S) == 0, program.output
    assert told in program.output


def test_mistakes_in_launches_of_pytest_are_told(start: Start) -> None:
    program = start(*PYTEST, "-W", "default", str(HERE / "pytest_mistakes.py"))
    assert program.wait(PATIENCE_S) == 1
    for said in (
        "coroutine_twice must stop iteration after yielding once",
        "yields_twice must stop iteration after yielding once",
        "a generator or async generator cannot be marked with shutdown=True",
        'the "fixture" keyword argument is required in pytest.mark.launch()',
        "must be either a launch description or a sequence that begins with one",
        "must have only one ReadyToTest action",
        "what stands before its yield failed",
        "4 failed, 2 skipped",
    ):
        assert said in program.output, program.output


def test_a_test_that_fails_is_told(start: Start, tmp_path: Path) -> None:
    program = start("zbot", "test", written(tmp_path), "number:=4")
    assert program.wait(PATIENCE_S) == 1
    assert "AssertionError: '4' != '3'" in program.output


def test_a_launch_that_ends_too_early_is_told(start: Start, tmp_path: Path) -> None:
    program = start("zbot", "test", written(tmp_path, ready="launch.actions.Shutdown()"))
    assert program.wait(PATIENCE_S) == 1
    assert "the launch ended before its tests could begin" in program.output


def test_a_file_without_a_description_is_pytest_s(start: Start, tmp_path: Path) -> None:
    path = tmp_path / "test_plain.py"
    path.write_text("def test_truth():\n    import rclpy\n", encoding="utf-8")
    program = start("zbot", "test", str(path), "--", "-q", "-p", "no:cacheprovider")
    assert program.wait(PATIENCE_S) == 0, program.output
    assert "1 passed" in program.output


def test_what_is_not_there_is_told(start: Start) -> None:
    program = start("zbot", "test", "missing")
    assert program.wait(PATIENCE_S) == 1
    assert "there is no missing" in program.output
