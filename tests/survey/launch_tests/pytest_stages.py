"""A launch that several tests of launch_pytest share; `test_launch_tests.py` runs them."""

import launch
import launch_pytest
import launch_testing.util
import pytest


@pytest.fixture(scope="module")
def seen():
    return []


@launch_pytest.fixture(scope="module", params=["slow", "fast"])
def launched(request):
    return [launch.LaunchDescription([launch_testing.util.KeepAliveProc()]), request.param]


def is_over(service):
    return service.event_loop is None and service._is_idle()


@pytest.mark.launch(fixture=launched, shutdown=True)
def test_the_end(seen, launched, launch_service):
    assert is_over(launch_service)
    seen.append((launched[1], "end"))


@pytest.mark.launch(fixture=launched)
def test_generator(seen, launched, launch_service):
    assert not is_over(launch_service)
    seen.append((launched[1], "before"))
    yield
    assert is_over(launch_service)
    seen.append((launched[1], "after"))


@pytest.mark.launch(fixture=launched)
async def test_asynchronous_generator(seen, launched, launch_service):
    assert not is_over(launch_service)
    seen.append((launched[1], "async before"))
    yield
    assert is_over(launch_service)
    seen.append((launched[1], "async after"))


@pytest.mark.launch(fixture=launched)
def test_plain(seen, launched, launch_service):
    assert not is_over(launch_service)
    seen.append((launched[1], "plain"))


def test_order(seen):
    stages = ["before", "async before", "plain", "end", "after", "async after"]
    assert seen == [(how, stage) for how in ("slow", "fast") for stage in stages]
