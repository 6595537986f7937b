"""ROS 2's `launch_ros`: nodes in launch files."""

from zbot.compat.submodules import submodules

__getattr__ = submodules(
    __name__,
    "actions",
    "descriptions",
    "event_handlers",
    "events",
    "parameter_descriptions",
    "ros_adapters",
    "substitutions",
    "utilities",
)
