# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `evaluate_condition_expression` and `InvalidConditionExpressionError`."""

from zbot.launch.condition import evaluate_condition_expression
from zbot.launch.errors import ConditionError as InvalidConditionExpressionError

__all__ = [
    "InvalidConditionExpressionError",
    "evaluate_condition_expression",
]
