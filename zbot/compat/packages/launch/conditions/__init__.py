"""Whether an action is to be done."""

from zbot.launch.condition import IfCondition as IfCondition
from zbot.launch.condition import LaunchConfigurationEquals as LaunchConfigurationEquals
from zbot.launch.condition import LaunchConfigurationNotEquals as LaunchConfigurationNotEquals
from zbot.launch.condition import UnlessCondition as UnlessCondition
