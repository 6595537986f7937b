"""Errors for wrong imports from ROS 2's packages, such as `from rclpy import Node`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.errors.suggestion import question, similar_names

if TYPE_CHECKING:
    from collections.abc import Sequence

_PACKAGES = Path(__file__).parent / "packages"
#: What to write in place of the import of a package of ROS 1.
_OF_ROS_1 = {
    "actionlib": "import rclpy.action",
    "dynamic_reconfigure": "self.declare_parameter('name', 1.0) in a node",
    "roslib": "import rclpy",
    "rospkg": "import ament_index_python",
    "rospy": "import rclpy",
    "tf": "import tf2_ros",
}


class OldPackageError(ZbotError, ModuleNotFoundError):
    """A program imports a package of ROS 1."""

    def __init__(self, package: str) -> None:
        super().__init__(
            f"No module named {package!r}, which is of ROS 1: write {_OF_ROS_1[package]}"
        )
        self.name = package


class WrongImportError(ZbotError, ModuleNotFoundError):
    """A program imports a name that a package of ROS 2 does not have."""

    def __init__(self, package: str, name: str, text: str) -> None:
        super().__init__(f"cannot import {name!r} from {package!r}{text}")
        # With the module's full name, `from package import name` would drop this error.
        self.name = package


def explain_missing_name(
    fullname: str, path: Sequence[str] | None
) -> OldPackageError | WrongImportError | None:
    """Return the error for a module that does not exist in a package that zbot has, or in ROS 2."""
    if path is None and fullname in _OF_ROS_1:
        return OldPackageError(fullname)
    package, _, name = fullname.rpartition(".")
    if path is None or not any(str(folder).startswith(str(_PACKAGES)) for folder in path):
        return None
    if name.startswith("_"):
        return None
    return WrongImportError(package, name, _advice(package.partition(".")[0], name))


def _advice(package: str, name: str) -> str:
    from zbot.compat.table import modules  # noqa: PLC0415 - needed only after an error

    known = {
        module: entry.names
        for module, entry in modules().items()
        if module.startswith(f"{package}.") and not module.rpartition(".")[2].startswith("_")
    }
    last_part = {module.rpartition(".")[2]: module for module in known}
    near = tuple(last_part[near_name] for near_name in similar_names(name, last_part))
    if not name.islower():  # a class
        classes = {
            class_name
            for names in known.values()
            for class_name in names
            if class_name[0].isupper()
        }
        name = name if name in classes else next(iter(similar_names(name, classes)), name)
    holders = [module for module, names in known.items() if name in names]
    if not holders or (near and name.islower()):
        return question(near, "; ")
    # `rclpy.duration` comes before `rclpy.qos`, and `launch.actions` before `launch.events`.
    best = last_part.get(name.lower()) or min(
        holders, key=lambda holder: ("event" in holder, len(holder))
    )
    return f": write from {best} import {name}"
