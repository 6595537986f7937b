"""What conditions ask."""

from zbot.launch.condition import evaluate_condition_expression as evaluate_condition_expression
from zbot.launch.errors import ConditionError as InvalidConditionExpressionError
