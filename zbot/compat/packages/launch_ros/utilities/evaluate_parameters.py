# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `evaluate_parameters`."""

from zbot.launch.parameters import evaluate_parameters

__all__ = [
    "evaluate_parameters",
]
