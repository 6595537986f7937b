"""Tests of a launch in launch_pytest's style; `test_launch_tests.py` runs them."""

import sys

import launch
import launch_pytest
import pytest
from launch_pytest.tools import process as process_tools

PROGRAM = """
import signal, sys
signal.signal(signal.SIGINT, lambda *_: sys.exit(0))
print("ready", flush=True)
signal.pause()
"""


@pytest.fixture(scope="module")
def waiting():
    return launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", PROGRAM], cached_output=True)


@launch_pytest.fixture(scope="module")
def launched(waiting):
    yield launch.LaunchDescription([waiting, launch_pytest.actions.ReadyToTest()])
    assert waiting.return_code == 0


@pytest.mark.launch(fixture=launched)
def test_output(waiting, launch_context):
    assert process_tools.wait_for_output_sync(
        launch_context, waiting, lambda text: text == "ready\n", timeout=10
    )
    process_tools.assert_output_sync(launch_context, waiting, lambda text: text, timeout=1)


@pytest.mark.launch(fixture=launched)
async def test_coroutine(waiting, launch_context):
    assert await process_tools.wait_for_start(launch_context, waiting, timeout=10)


@pytest.mark.launch(fixture=launched)
@pytest.mark.parametrize("times", [1, 2])
def test_parameters(times, launch_service):
    assert times
    assert not launch_service.context.is_shutdown


@pytest.mark.launch(fixture=launched)
def test_both_halves(waiting):
    assert waiting.return_code is None
    yield
    assert waiting.return_code == 0


@pytest.mark.launch(fixture=launched, shutdown=True)
def test_after_shutdown(waiting):
    assert waiting.return_code == 0
