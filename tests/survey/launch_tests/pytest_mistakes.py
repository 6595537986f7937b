"""Mistakes in tests of launch_pytest; `test_launch_tests.py` looks at what is said of them."""

import launch
import launch_pytest
import pytest
from launch_pytest.actions import ReadyToTest


@launch_pytest.fixture
def launched():
    return launch.LaunchDescription([ReadyToTest()])


@launch_pytest.fixture(scope="module")
def shared():
    return launch.LaunchDescription([ReadyToTest()])


@launch_pytest.fixture
def nothing():
    return [object(), "no launch"]


@launch_pytest.fixture
def ready_twice():
    return launch.LaunchDescription([ReadyToTest(), ReadyToTest()])


@pytest.mark.launch(fixture=launched)
def test_yields_twice():
    yield
    yield


@pytest.mark.launch(fixture=launched)
async def test_coroutine_twice():
    yield
    yield


@pytest.mark.launch(fixture=launched, shutdown=True)
def test_two_ends():
    yield


@pytest.mark.launch(fixture=shared)
def test_fails_before_its_yield():
    assert False
    yield


@pytest.mark.launch
def test_no_fixture():
    pass


@pytest.mark.launch(fixture=nothing)
def test_no_description():
    pass


@pytest.mark.launch(fixture=ready_twice)
def test_ready_twice():
    pass
