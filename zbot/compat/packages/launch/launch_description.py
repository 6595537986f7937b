# Written by python -m zbot.compat.generator; do not edit.
"""Description of a launch, with names that ROS 2's module imports for itself."""

from zbot.launch import Action, LaunchContext, LaunchDescription, LaunchDescriptionEntity
from zbot.launch.actions import DeclareLaunchArgument

__all__ = [
    "Action",
    "DeclareLaunchArgument",
    "LaunchContext",
    "LaunchDescription",
    "LaunchDescriptionEntity",
]
