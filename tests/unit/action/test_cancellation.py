"""Goals that a cancel request selects."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from zbot.action.cancellation import (
    ERROR_GOAL_TERMINATED,
    ERROR_NONE,
    ERROR_UNKNOWN_GOAL_ID,
    CancelQuery,
)
from zbot.action.goal_state import GoalState

from action_msgs.srv import CancelGoal


@dataclass(frozen=True)
class Goal:
    name: str
    stamp_ns: int
    state: GoalState

    @property
    def key(self) -> bytes:
        return self.name.encode().ljust(16, b"\0")


GOALS = [
    Goal("waits", 10, GoalState.ACCEPTED),
    Goal("runs", 20, GoalState.EXECUTING),
    Goal("stops", 30, GoalState.CANCELING),
    Goal("done", 40, GoalState.SUCCEEDED),
    Goal("late", 50, GoalState.EXECUTING),
]


@pytest.mark.parametrize(
    ("name", "stamp_ns", "chosen", "code"),
    [
        ("", 0, ["waits", "runs", "late"], ERROR_NONE),
        ("runs", 0, ["runs"], ERROR_NONE),
        ("waits", 0, ["waits"], ERROR_NONE),
        ("", 20, ["waits", "runs"], ERROR_NONE),
        ("", 9, [], ERROR_NONE),
        ("", 99, ["waits", "runs", "late"], ERROR_NONE),
        ("late", 10, ["waits", "late"], ERROR_NONE),
        ("done", 10, ["waits"], ERROR_NONE),
        ("stops", 0, [], ERROR_GOAL_TERMINATED),
        ("done", 0, [], ERROR_GOAL_TERMINATED),
        ("nobody", 0, [], ERROR_UNKNOWN_GOAL_ID),
    ],
)
def test_a_request_selects_one_goal_or_all_until_a_time(
    name: str, stamp_ns: int, chosen: list[str], code: int
) -> None:
    goals, found = CancelQuery(Goal(name, 0, GoalState.UNKNOWN).key, stamp_ns).choose(GOALS)
    assert ([goal.name for goal in goals], found) == (chosen, code)


def test_codes_are_those_of_the_service() -> None:
    response = CancelGoal.Response
    assert (response.ERROR_NONE, response.ERROR_UNKNOWN_GOAL_ID) == (
        ERROR_NONE,
        ERROR_UNKNOWN_GOAL_ID,
    )
    assert response.ERROR_GOAL_TERMINATED == ERROR_GOAL_TERMINATED
