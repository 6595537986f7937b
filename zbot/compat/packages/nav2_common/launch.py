"""Substitutions that change files before nodes read them."""

from zbot.launch.substitutions.nav2_common import (
    HasNodeParams,
    LaunchConfigAsBool,
    ParseMultiRobotPose,
    ReplaceString,
    RewrittenYaml,
)
