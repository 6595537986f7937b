"""Tests of launch files that zbot has in place of those of ROS 2's packages."""

from __future__ import annotations

from typing import Any

from zbot.launch import LaunchContext
from zbot.launch.actions import IncludeLaunchDescription, Node
from zbot.launch.substitution import perform
from zbot.package import package_share


def started(package: str, file: str, **given: str) -> dict[str, list[str]]:
    """Return the arguments of the nodes that a launch file starts, by their programs."""
    context = LaunchContext()
    path = str(package_share(package) / "launch" / file)
    waiting: list[Any] = [IncludeLaunchDescription(path, launch_arguments=given.items())]
    found = {}
    while waiting:
        entity = waiting.pop(0)
        if not isinstance(entity, Node):
            waiting[:0] = entity.visit(context) or ()
        elif entity.condition is None or entity.condition.evaluate(context):
            words = [perform(context, word) for word in entity.arguments]
            found[perform(context, entity.executable)] = words
    return found


def test_rviz_launch_shows_the_view_of_nav2_or_another_one() -> None:
    usual = str(package_share("nav2_bringup") / "rviz" / "nav2_default_view.rviz")
    assert started("nav2_bringup", "rviz_launch.py") == {"rviz2": ["-d", usual]}
    given = {"namespace": "", "use_namespace": "False", "rviz_config": "/a.rviz"}
    assert started("nav2_bringup", "rviz_launch.py", **given) == {"rviz2": ["-d", "/a.rviz"]}
