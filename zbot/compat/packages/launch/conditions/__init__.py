"""Conditions that decide whether an action is done."""

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
