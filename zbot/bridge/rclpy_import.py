"""Import of ROS 2's own rclpy (not zbot's), and of ROS 2's classes of messages and services."""

from __future__ import annotations

import importlib
from typing import Any

from zbot.bridge.errors import no_rclpy_error


def import_rclpy() -> Any:
    """Return ROS 2's own module `rclpy`.

    Raises:
        BridgeError: rclpy is not installed here, or a part of rclpy cannot be loaded.
    """
    try:
        rclpy = importlib.import_module("rclpy")
        node = importlib.import_module("rclpy.node")
    except ImportError as error:
        raise no_rclpy_error(str(error)) from error
    if node.Node.__module__.startswith("zbot."):
        raise no_rclpy_error("only zbot's own rclpy is installed")
    return rclpy


def genuine_class(type_name: str) -> type[Any] | None:
    """Return ROS 2's class of a message or service, or `None` if this Python has no such class.

    The name may belong to a part of an action, e.g. `pkg/action/Fibonacci_SendGoal`.
    """
    package, kind, name = type_name.split("/")
    try:
        module = importlib.import_module(f"{package}.{kind}")
    except ImportError:
        return None
    owner, _, part = name.partition("_")
    found = getattr(module, name, None) if kind != "action" else getattr(module, owner, None)
    if found is None or not hasattr(type(found), "__import_type_support__"):
        return None  # zbot's own class, which the middleware cannot send
    if not part or kind != "action":
        return found  # type: ignore[no-any-return] # the module has any attributes
    parts = {
        "SendGoal": "SendGoalService",
        "GetResult": "GetResultService",
        "FeedbackMessage": "FeedbackMessage",
    }
    return getattr(found.Impl, parts[part], None) if part in parts else None
