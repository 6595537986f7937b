"""Tests of launch_pytest: a kiln for each test, and one that several tests share."""

import sys
from collections.abc import AsyncIterator, Iterator
from typing import Any

import launch_pytest
import pytest
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_pytest.actions import ReadyToTest
from launch_pytest.tools import process as tools

HEAT = """
import signal, sys, threading
signal.signal(signal.SIGINT, lambda *_: sys.exit(0))
print("hot", flush=True)
threading.Event().wait()
"""


@pytest.fixture
def kiln() -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", HEAT], cached_output=True)


@launch_pytest.fixture
def firing(kiln: ExecuteProcess) -> Iterator[LaunchDescription]:
    yield LaunchDescription([kiln, ReadyToTest()])
    assert kiln.return_code == 0


@pytest.mark.launch(fixture=firing)
def test_the_kiln_is_hot(kiln: ExecuteProcess, launch_context: Any) -> None:
    def is_hot(text: str) -> None:
        assert text.strip() == "hot"

    tools.assert_output_sync(launch_context, kiln, is_hot, timeout=60)
    assert not tools.wait_for_output_sync(launch_context, kiln, lambda text: "cold" in text, 0.01)


@pytest.mark.launch(fixture=firing)
async def test_it_starts_in_a_coroutine(kiln: ExecuteProcess, launch_context: Any) -> None:
    assert await tools.wait_for_start(launch_context, kiln, timeout=60)
    assert await tools.wait_for_output(launch_context, kiln, lambda text: "hot" in text, 60)
    assert not await tools.wait_for_exit(launch_context, kiln, timeout=0.01)


@pytest.mark.launch(fixture=firing)
def test_it_burns_until_the_yield(kiln: ExecuteProcess, launch_context: Any) -> Iterator[None]:
    assert tools.wait_for_output_sync(launch_context, kiln, lambda text: "hot" in text, 60)
    assert kiln.return_code is None
    yield
    assert kiln.return_code == 0


@pytest.fixture(scope="module")
def diary() -> list[tuple[str, str]]:
    return []


@launch_pytest.fixture(scope="module", params=["bricks", "bowls"], auto_shutdown=False)
def shared(request: Any) -> tuple[LaunchDescription, str]:
    return LaunchDescription([ReadyToTest()]), request.param


def is_over(launch_service: Any) -> bool:
    return bool(launch_service.context.is_shutdown)


@pytest.mark.launch(fixture=shared, shutdown=True)
def test_the_kiln_cools(diary: list[Any], shared: Any, launch_service: Any) -> None:
    assert is_over(launch_service)
    diary.append((shared[1], "cooled"))


@pytest.mark.launch(fixture=shared)
def test_is_glazed(diary: list[Any], shared: Any, launch_service: Any) -> Iterator[None]:
    assert not is_over(launch_service)
    diary.append((shared[1], "glazed"))
    yield
    assert is_over(launch_service)
    diary.append((shared[1], "shines"))


@pytest.mark.launch(fixture=shared)
async def test_is_fired(diary: list[Any], shared: Any, launch_service: Any) -> AsyncIterator[None]:
    assert not is_over(launch_service)
    diary.append((shared[1], "fired"))
    yield
    assert is_over(launch_service)
    diary.append((shared[1], "hard"))


@pytest.mark.launch(fixture=shared)
def test_is_looked_at(diary: list[Any], shared: Any, launch_service: Any) -> None:
    assert not is_over(launch_service)
    diary.append((shared[1], "seen"))


def test_what_ends_a_launch_came_last(diary: list[tuple[str, str]]) -> None:
    during, after = ["glazed", "fired", "seen"], {"cooled", "shines", "hard"}
    for ware in ("bricks", "bowls"):
        stages = [stage for made, stage in diary if made == ware]
        assert stages[:3] == during
        assert set(stages[3:]) == after
    assert [made for made, _ in diary] == ["bricks"] * 6 + ["bowls"] * 6
