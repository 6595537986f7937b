"""Requests to cancel goals: one goal, all goals, or the goals accepted up to a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.action.goal_state import GoalState

# The return codes of action_msgs/srv/CancelGoal.
ERROR_NONE = 0
ERROR_REJECTED = 1
ERROR_UNKNOWN_GOAL_ID = 2
ERROR_GOAL_TERMINATED = 3

_NO_GOAL_ID = bytes(16)


class Goal(Protocol):
    """The part of a goal that a cancel request uses."""

    @property
    def key(self) -> bytes:
        """The goal's id, 16 bytes."""
        ...

    @property
    def stamp_ns(self) -> int:
        """When the goal was accepted, nanoseconds."""
        ...

    @property
    def state(self) -> GoalState:
        """The goal's state."""
        ...


GoalT = TypeVar("GoalT", bound=Goal)


@dataclass(frozen=True)
class CancelQuery:
    """A cancel request. The request selects all goals if both values are zero.

    Attributes:
        key: The id of a goal that the request selects. Zero means no goal.
        stamp_ns: The request also selects goals accepted at or before this time. Zero means no
            time.
    """

    key: bytes
    stamp_ns: int

    def choose(self, goals: Iterable[GoalT]) -> tuple[list[GoalT], int]:
        """Return the goals to cancel, and the return code for a server that accepts the request."""
        if self.key != _NO_GOAL_ID and not self.stamp_ns:
            return self._choose_one(goals)
        return [
            goal for goal in goals if self._selects(goal) and goal.state.is_cancelable
        ], ERROR_NONE

    def _selects(self, goal: Goal) -> bool:
        if self.key == _NO_GOAL_ID and not self.stamp_ns:
            return True
        return goal.key == self.key or goal.stamp_ns <= self.stamp_ns

    def _choose_one(self, goals: Iterable[GoalT]) -> tuple[list[GoalT], int]:
        for goal in goals:
            if goal.key == self.key:
                if goal.state.is_cancelable:
                    return [goal], ERROR_NONE
                return [], ERROR_GOAL_TERMINATED
        return [], ERROR_UNKNOWN_GOAL_ID
