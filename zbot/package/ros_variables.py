"""Environment variables that a ROS 2 which was sourced sets, with zbot's values for them."""

from __future__ import annotations

import os

#: The distribution of ROS 2 whose definitions and formats zbot has.
DISTRO = "kilted"
_VALUES = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3", "ROS_DISTRO": DISTRO}


def ros_variable(name: str) -> str:
    """Return the value of an environment variable, or zbot's value, or an empty string."""
    return os.environ.get(name) or _VALUES.get(name, "")


def set_ros_variables() -> None:
    """Set the variables of this process and its children that are not set."""
    for name, value in _VALUES.items():
        os.environ.setdefault(name, value)
