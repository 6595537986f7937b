"""Tests of `LaunchTestRunner`, which runs the launches of a test file in order."""

from __future__ import annotations

import sys
import unittest
from types import ModuleType
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch import LaunchDescription
from zbot.launch.actions import ExecuteProcess, Shutdown, TimerAction
from zbot.launch.testing import running_launch, test_run
from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.marker import keep_alive, parametrize, post_shutdown_test
from zbot.launch.testing.test_action import ReadyToTest
from zbot.launch.testing.test_runner import LaunchTestRunner

if TYPE_CHECKING:
    from collections.abc import Callable

Test = unittest.TestCase


def runs_of(describe: Callable[..., Any], **cases: type[Test]) -> list[test_run.TestRun]:
    module = ModuleType("robot_launch_test")
    vars(module).update(cases, generate_test_description=describe)
    return test_run.test_runs(module)


def ready() -> LaunchDescription:
    return LaunchDescription([ReadyToTest()])


class TestBeside(Test):
    __test__ = False

    def test_number(self, number: int, test_args: Any) -> None:
        assert number != 2
        assert test_args["robot"] == "a"


@post_shutdown_test()
class TestAfter(Test):
    __test__ = False

    def test_number(self, number: int) -> None:
        assert number != 3


def test_each_run_has_one_result() -> None:
    @keep_alive
    @parametrize("number", [1, 2, 3])
    def describe(number: int) -> LaunchDescription:
        assert number
        return ready()

    runner = LaunchTestRunner(runs_of(describe, A=TestBeside, B=TestAfter), ["robot:=a"])
    runner.validate()
    results = runner.run()
    assert [run.name for run in results] == ["[1]", "[2]", "[3]"]
    assert [result.wasSuccessful() for result in results.values()] == [True, False, False]
    assert [result.testsRun for result in results.values()] == [2, 2, 2]


def test_a_launch_that_ended_early_is_the_last(capsys: pytest.CaptureFixture[str]) -> None:
    describe = parametrize("number", [1, 2])(
        lambda number: LaunchDescription([Shutdown(reason=f"{number}")])
    )
    (result,) = LaunchTestRunner(runs_of(describe, A=TestBeside)).run().values()
    assert not result.wasSuccessful()
    assert "the launch ended before its tests could begin" in capsys.readouterr().err


def test_a_skipped_description_skips_its_tests() -> None:
    describe = unittest.skip("no robot here")(ready)
    (result,) = LaunchTestRunner(runs_of(describe, A=TestBeside, B=TestAfter)).run().values()
    assert result.wasSuccessful()
    assert [reason for _, reason in result.skipped] == ["no robot here"] * 2
    assert result.testsRun == 2


@pytest.mark.parametrize(
    ("describe", "said"),
    [
        (lambda ready_fn: ready_fn, "unexpected extra argument 'ready_fn'"),
        (parametrize("number", [1])(lambda: None), r"Could not find an argument .* 'number'"),
    ],
)
def test_arguments_of_descriptions_are_checked(describe: Callable[..., Any], said: str) -> None:
    with pytest.raises(LaunchTestError, match=said):
        LaunchTestRunner(runs_of(describe)).validate()


def test_a_description_needs_its_ready_to_test() -> None:
    (run,) = runs_of(lambda: LaunchDescription([TimerAction(period=1.0, actions=[ReadyToTest()])]))
    description, given = run.normalized_test_description(ready_fn=list)
    assert (len(description.entities), given) == (2, {})
    (run,) = runs_of(lambda: LaunchDescription([]))
    with pytest.raises(LaunchTestError, match="containing a ReadyToTest action"):
        run.normalized_test_description(ready_fn=list)


def test_a_launch_that_does_not_end_in_time_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    deaf = "import signal, time; signal.signal(signal.SIGINT, signal.SIG_IGN); time.sleep(60)"
    process = ExecuteProcess(cmd=[sys.executable, "-c", deaf], sigterm_timeout="1.0")
    launch = running_launch.RunningLaunch(LaunchDescription([process, ReadyToTest()]))
    launch.wait_until_ready()
    with monkeypatch.context() as short:
        short.setattr(running_launch, "_LONGEST_END_S", 0.01)
        with pytest.raises(LaunchTestError, match=r"did not end within 0\.01 s"):
            launch.stop()
    launch.stop()
    assert launch.is_over
