from __future__ import annotations

import unittest

import pytest

from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.marker import (
    keep_alive,
    markers_of,
    parametrize,
    post_shutdown_test,
    ready_to_test_action_timeout,
    retry_on_failure,
)


def test_marks_are_kept_with_the_function() -> None:
    @keep_alive
    @ready_to_test_action_timeout(3.0)
    @parametrize("speed, name", [(1, "slow"), (2, "fast")])
    def describe() -> None: ...

    assert markers_of(describe) == {
        "keep_alive": True,
        "ready_timeout": 3.0,
        "rows": [{"speed": 1, "name": "slow"}, {"speed": 2, "name": "fast"}],
    }


def test_a_single_argument_needs_no_tuples() -> None:
    @parametrize("speed", [1, 2])
    def describe() -> None: ...

    assert markers_of(describe)["rows"] == [{"speed": 1}, {"speed": 2}]


def test_a_case_can_come_after_the_launch() -> None:
    @post_shutdown_test()
    class Case(unittest.TestCase): ...

    assert Case.__post_shutdown_test__ is True  # type: ignore[attr-defined]


def test_a_failed_test_is_repeated_up_to_its_limit() -> None:
    tries: list[int] = []

    @retry_on_failure(times=3)
    def third_time() -> str:
        tries.append(1)
        assert len(tries) == 3
        return "good"

    assert third_time() == "good"

    @retry_on_failure(times=2)
    def never() -> None:
        raise AssertionError("no")

    with pytest.raises(AssertionError, match="no"):
        never()
    with pytest.raises(LaunchTestError):
        retry_on_failure(times=0)
