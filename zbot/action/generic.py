"""What the classes of an action's two ends are generic in: its goal, result and feedback."""

from __future__ import annotations

from typing import Any, Generic, TypeVar

GoalT = TypeVar("GoalT")
ResultT = TypeVar("ResultT")
FeedbackT = TypeVar("FeedbackT")


class ActionGeneric(Generic[GoalT, ResultT, FeedbackT]):
    """Base of the classes that an annotation may name with the types of an action's messages."""

    def __class_getitem__(cls, parameters: tuple[Any, ...]) -> Any:
        # A fourth, the action's `Impl`, is one of rclpy's since ROS 2 Lyrical; none is told by it.
        return super().__class_getitem__(parameters[:3])  # type: ignore[misc]
