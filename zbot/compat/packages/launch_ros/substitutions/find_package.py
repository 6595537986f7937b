# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `FindPackage` and `FindPackagePrefix` and `FindPackageShare`."""

from zbot.launch.substitutions import FindPackage, FindPackagePrefix, FindPackageShare

__all__ = [
    "FindPackage",
    "FindPackagePrefix",
    "FindPackageShare",
]
