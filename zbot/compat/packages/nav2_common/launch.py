# Written by python -m zbot.compat.generator; do not edit.
"""Substitutions that change files before nodes read them."""

from zbot.launch.substitutions.nav2_common import (
    HasNodeParams,
    LaunchConfigAsBool,
    ParseMultiRobotPose,
    ReplaceString,
    RewrittenYaml,
)

__all__ = [
    "HasNodeParams",
    "LaunchConfigAsBool",
    "ParseMultiRobotPose",
    "ReplaceString",
    "RewrittenYaml",
]
