"""`SetLaunchConfiguration` under its own module's name."""

from zbot.launch.actions import SetLaunchConfiguration as SetLaunchConfiguration
