"""Function that evaluates the expression of a condition."""

from zbot.launch.condition import evaluate_condition_expression
from zbot.launch.errors import ConditionError as InvalidConditionExpressionError
