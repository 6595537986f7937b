# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PythonExpression`."""

from zbot.launch.substitutions import PythonExpression

__all__ = [
    "PythonExpression",
]
