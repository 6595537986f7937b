"""`IfCondition` under its own module's name."""

from zbot.launch.condition import IfCondition
