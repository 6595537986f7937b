"""`UnlessCondition` under its own module's name."""

from zbot.launch.condition import UnlessCondition
