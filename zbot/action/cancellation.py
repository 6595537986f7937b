"""Which goals a cancel request means: one, all, or those accepted until a time (pure)."""

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

_NOBODY = bytes(16)


class Goal(Protocol):
    """What has to be known of a goal."""

    @property
    def key(self) -> bytes:
        """The goal's id, 16 bytes."""
        ...

    @property
    def stamp_ns(self) -> int:
        """When it was accepted, nanoseconds."""
        ...

    @property
    def state(self) -> GoalState:
        """Where it stands."""
        ...


GoalT = TypeVar("GoalT", bound=Goal)


@dataclass(frozen=True)
class CancelQuery:
    """A cancel request: all goals if both are zero, all until the stamp if that is not.

    Attributes:
        key: A goal's id; zero for none in particular.
        stamp_ns: Goals accepted at or before it are meant too; zero for none.
    """

    key: bytes
    stamp_ns: int

    def choose(self, goals: Iterable[GoalT]) -> tuple[list[GoalT], int]:
        """Return the goals to cancel, and the return code if the server agrees."""
        if self.key != _NOBODY and not self.stamp_ns:
            return self._choose_one(goals)
        return [
            goal for goal in goals if self._means(goal) and goal.state.is_cancelable
        ], ERROR_NONE

    def _means(self, goal: Goal) -> bool:
        if self.key == _NOBODY and not self.stamp_ns:
            return True
        return goal.key == self.key or goal.stamp_ns <= self.stamp_ns

    def _choose_one(self, goals: Iterable[GoalT]) -> tuple[list[GoalT], int]:
        for goal in goals:
            if goal.key == self.key:
                if goal.state.is_cancelable:
                    return [goal], ERROR_NONE
                return [], ERROR_GOAL_TERMINATED
        return [], ERROR_UNKNOWN_GOAL_ID
