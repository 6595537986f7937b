# Written by python -m zbot.compat.generator; do not edit.
"""Conditions that decide whether an action is done."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.condition import (
    AndCondition,
    IfCondition,
    LaunchConfigurationEquals,
    LaunchConfigurationNotEquals,
    OrCondition,
    UnlessCondition,
    evaluate_condition_expression,
)
from zbot.launch.errors import ConditionError as InvalidConditionExpressionError

__all__ = [
    "AndCondition",
    "IfCondition",
    "InvalidConditionExpressionError",
    "LaunchConfigurationEquals",
    "LaunchConfigurationNotEquals",
    "OrCondition",
    "UnlessCondition",
    "evaluate_condition_expression",
]

if TYPE_CHECKING:
    from . import and_condition as and_condition
    from . import evaluate_condition_expression_impl as evaluate_condition_expression_impl
    from . import if_condition as if_condition
    from . import launch_configuration_equals as launch_configuration_equals
    from . import launch_configuration_not_equals as launch_configuration_not_equals
    from . import or_condition as or_condition
    from . import unless_condition as unless_condition
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "and_condition",
            "evaluate_condition_expression_impl",
            "if_condition",
            "launch_configuration_equals",
            "launch_configuration_not_equals",
            "or_condition",
            "unless_condition",
        ),
    )[0]
