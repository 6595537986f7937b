# Written by python -m zbot.compat.generator; do not edit.
"""Client of Nav2."""

from zbot.libraries.navigation.navigator import BasicNavigator, RunningTask, TaskResult
from zbot.time import Duration as rclpyDuration
from builtin_interfaces.msg import Duration
from geometry_msgs.msg import PoseStamped

__all__ = [
    "BasicNavigator",
    "Duration",
    "PoseStamped",
    "RunningTask",
    "TaskResult",
    "rclpyDuration",
]
