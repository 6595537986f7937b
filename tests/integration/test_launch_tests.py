"""Test files for launches, run by `zbot test` and by pytest as processes of their own."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.conftest import Start

FILES = Path(__file__).parents[1] / "programs" / "launch_tests"
PYTEST = (sys.executable, "-m", "pytest", "-p", "zbot.compat.pytest_plugin", "-p",
          "no:cacheprovider", "-rA", "--rootdir", "/")  # fmt: skip
TIMEOUT_S = 60
GATE = """
import sys, unittest
import launch, launch_testing.actions

def generate_test_description():
    wait = "import threading; threading.Event().wait()"
    gate = launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", wait])
    return launch.LaunchDescription([gate, {ready}])

class TestGate(unittest.TestCase):
    def test_width(self, test_args):
        self.assertEqual(test_args.get("width", "3"), "3")
"""


def gate(folder: Path, ready: str = "launch_testing.actions.ReadyToTest()") -> str:
    path = folder / "gate_launch.py"
    path.write_text(GATE.format(ready=ready), encoding="utf-8")
    return str(path)


def test_test_cases_run_beside_and_after_a_launch(start: Start) -> None:
    program = start("zbot", "test", str(FILES / "mill_launch.py"))
    assert program.wait(TIMEOUT_S) == 0, program.output
    assert program.output.count("Ran 4 tests") == 2
    assert program.output.count("Ran 2 tests") == 2


def test_a_description_need_not_be_a_def(start: Start, tmp_path: Path) -> None:
    lines = (
        "generate_test_description = functools.partial(describe, 1)",
        "from canal_description import (\n    describe as generate_test_description,\n)",
    )
    text = GATE.format(ready="launch_testing.actions.ReadyToTest()")
    text = text.replace("generate_test_description()", "describe(number=1)")
    (tmp_path / "canal_description.py").write_text(text.partition("class")[0], encoding="utf-8")
    paths = [tmp_path / "assigned_launch.py", tmp_path / "imported_launch.py"]
    for path, line in zip(paths, lines, strict=True):
        path.write_text(f"import functools\n{text}\n{line}\n", encoding="utf-8")
    program = start("zbot", "test", *map(str, paths))
    assert program.wait(TIMEOUT_S) == 0, program.output
    assert program.output.count("Ran 1 test") == 2


@pytest.mark.parametrize(("file", "passed"), [("mill_launch.py", 2), ("kiln_pytest.py", 16)])
def test_launch_tests_run_under_pytest(start: Start, file: str, passed: int) -> None:
    program = start(*PYTEST, str(FILES / file))
    assert program.wait(TIMEOUT_S) == 0, program.output
    assert f"= {passed} passed in " in program.output


def test_pytest_launches_a_description_without_a_mark(start: Start, tmp_path: Path) -> None:
    text = GATE.format(ready="launch_testing.actions.ReadyToTest()")
    (tmp_path / "test_gate.py").write_text(text, encoding="utf-8")
    program = start(*PYTEST, str(tmp_path))
    assert program.wait(TIMEOUT_S) == 0, program.output
    assert "PASSED" in program.output
    assert "launch" in program.output.partition("PASSED")[2].splitlines()[0]


def test_mistakes_in_tests_of_launch_pytest_are_reported(start: Start) -> None:
    program = start(*PYTEST, "-W", "default", str(FILES / "kiln_mistakes.py"))
    assert program.wait(TIMEOUT_S) == 1
    for message in (
        "test_opened_twice must stop iteration after yielding once",
        "test_awaited_twice must stop iteration after yielding once",
        "a generator or async generator cannot be marked with shutdown=True",
        'the "fixture" keyword argument is required in pytest.mark.launch()',
        "must be either a launch description or a sequence that begins with one",
        "must have only one ReadyToTest action",
        "the test failed before its yield",
        "4 failed, 2 skipped",
    ):
        assert message in program.output, program.output
    assert "it ran without a launch" not in program.output.partition("short test summary")[2]


@pytest.mark.parametrize(
    ("ready", "words", "message"),
    [
        ("launch_testing.actions.ReadyToTest()", ("width:=4",), "AssertionError: '4' != '3'"),
        ("launch.actions.Shutdown()", (), "the launch ended before its tests could begin"),
    ],
    ids=["a test fails", "the launch ends too early"],
)
def test_a_failure_is_reported(
    start: Start, tmp_path: Path, ready: str, words: tuple[str, ...], message: str
) -> None:
    program = start("zbot", "test", gate(tmp_path, ready), *words)
    assert program.wait(TIMEOUT_S) == 1
    assert message in program.output


def test_pytest_runs_a_file_without_a_description(start: Start, tmp_path: Path) -> None:
    path = tmp_path / "test_plain.py"
    path.write_text("def test_import():\n    import rclpy\n", encoding="utf-8")
    program = start("zbot", "test", str(path), "--", "-q", "-p", "no:cacheprovider")
    assert program.wait(TIMEOUT_S) == 0, program.output
    assert "1 passed" in program.output


def test_a_launch_test_may_name_a_package_that_is_not_here(start: Start, tmp_path: Path) -> None:
    share = "__import__('ament_index_python').get_package_share_directory('stage_ros2')"
    world = f"launch.actions.IncludeLaunchDescription({share} + '/launch/gz_sim.launch.py')"
    program = start(
        "zbot", "test", gate(tmp_path, f"{world}, launch_testing.actions.ReadyToTest()")
    )
    assert program.wait(TIMEOUT_S) == 0, program.output
    assert "stage_ros2 is left out: it is a simulator in C++" in program.output


def test_a_missing_file_is_reported(start: Start) -> None:
    program = start("zbot", "test", "missing")
    assert program.wait(TIMEOUT_S) == 1
    assert "there is no missing" in program.output


def test_a_module_may_import_the_marks_of_pytest(start: Start, tmp_path: Path) -> None:
    text = "from pytest import mark\n@mark.parametrize('x', [1, 2])\ndef test_x(x): assert x\n"
    (tmp_path / "test_marks.py").write_text(text)
    program = start(*PYTEST, "-W", "error", str(tmp_path / "test_marks.py"))
    assert program.wait(TIMEOUT_S) == 0, program.output
    assert "2 passed" in program.output
