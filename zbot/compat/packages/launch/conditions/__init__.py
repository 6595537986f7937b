"""Whether an action is to be done."""

from zbot.launch.condition import AndCondition as AndCondition
from zbot.launch.condition import IfCondition as IfCondition
from zbot.launch.condition import LaunchConfigurationEquals as LaunchConfigurationEquals
from zbot.launch.condition import LaunchConfigurationNotEquals as LaunchConfigurationNotEquals
from zbot.launch.condition import OrCondition as OrCondition
from zbot.launch.condition import UnlessCondition as UnlessCondition
from zbot.launch.condition import evaluate_condition_expression as evaluate_condition_expression
from zbot.launch.errors import ConditionError as InvalidConditionExpressionError
