"""Environment variables that a sourced ROS 2 sets, with zbot's values for them."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from zbot.package.user_folders import cache_folder

#: Environment variable with the prefixes of installed packages.
AMENT_PREFIX_PATH = "AMENT_PREFIX_PATH"
#: The distribution of ROS 2 whose definitions and formats zbot has.
DISTRO = "kilted"
_VALUES = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3", "ROS_DISTRO": DISTRO}
#: Launch files append folders to them. zbot finds the models of the workspace without them.
_GAZEBO = (
    *("GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH"),
    *("GAZEBO_MODEL_PATH", "GAZEBO_RESOURCE_PATH"),
)


def ros_variable(name: str) -> str:
    """Return an environment variable's value, or else zbot's value, or else an empty string."""
    return os.environ.get(name) or _VALUES.get(name, "")


def set_ros_variables() -> None:
    """Set the variables that are not set yet, for this process and its child processes.

    Without an installed ROS 2, the command `ros2` on the PATH is zbot.
    """
    from zbot.package.errors import WrapperError  # noqa: PLC0415 - not needed by readers
    from zbot.package.zbot_command import add_ros2_to_path  # noqa: PLC0415 - as above

    for name, value in {**_VALUES, **dict.fromkeys(_GAZEBO, "")}.items():
        os.environ.setdefault(name, value)
    with contextlib.suppress(WrapperError, RuntimeError):  # RuntimeError: there is no home folder
        os.environ.update(add_ros2_to_path(os.environ))


def ament_prefixes() -> list[Path]:
    """Return the prefixes in AMENT_PREFIX_PATH, without those that zbot makes for a workspace."""
    made = cache_folder() / "packages"
    named = map(Path, filter(None, os.environ.get(AMENT_PREFIX_PATH, "").split(os.pathsep)))
    return [prefix for prefix in named if prefix.parent != made]
