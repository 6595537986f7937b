"""Tests of launch_pytest that are wrong, each in another way."""

from collections.abc import AsyncIterator, Iterator

import launch_pytest
import pytest
from launch import LaunchDescription
from launch_pytest.actions import ReadyToTest


@launch_pytest.fixture(auto_shutdown=False)
def cold() -> LaunchDescription:
    return LaunchDescription([ReadyToTest()])


@launch_pytest.fixture(scope="module", auto_shutdown=False)
def cracked() -> LaunchDescription:
    return LaunchDescription([ReadyToTest()])


@launch_pytest.fixture
def clay() -> str:
    return "no description"


@launch_pytest.fixture
def overheated() -> LaunchDescription:
    return LaunchDescription([ReadyToTest(), ReadyToTest()])


@pytest.mark.launch(fixture=cold)
def test_opened_twice() -> Iterator[None]:
    yield
    yield


@pytest.mark.launch(fixture=cold)
async def test_awaited_twice() -> AsyncIterator[None]:
    yield
    yield


@pytest.mark.launch(fixture=cold, shutdown=True)
def test_two_ends() -> Iterator[None]:
    yield


@pytest.mark.launch(fixture=cracked)
def test_breaks_before_its_yield() -> Iterator[None]:
    pytest.fail("it broke")
    yield


@pytest.mark.launch
def test_no_kiln() -> None:
    pytest.fail("it ran without a launch")


@pytest.mark.launch(fixture=clay)
def test_no_description() -> None:
    pytest.fail("it ran without a launch")


@pytest.mark.launch(fixture=overheated)
def test_ready_twice() -> None:
    pytest.fail("it ran without a launch")
