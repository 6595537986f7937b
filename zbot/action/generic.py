"""Type parameters of action clients and servers: goal, result and feedback."""

from __future__ import annotations

from typing import Any, Generic, TypeVar

GoalT = TypeVar("GoalT")
ResultT = TypeVar("ResultT")
FeedbackT = TypeVar("FeedbackT")


class ActionGeneric(Generic[GoalT, ResultT, FeedbackT]):
    """Base of the generic classes for actions, such as `ActionClient[Goal, Result, Feedback]`."""

    def __class_getitem__(cls, parameters: tuple[Any, ...]) -> Any:
        # Since ROS 2 Lyrical, rclpy has a fourth parameter, the action's `Impl`. zbot ignores it.
        return super().__class_getitem__(parameters[:3])  # type: ignore[misc]
