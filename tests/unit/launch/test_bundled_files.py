"""Tests of launch files that zbot has in place of those of ROS 2's packages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from zbot.launch import LaunchContext
from zbot.launch.actions import IncludeLaunchDescription, Node
from zbot.launch.substitution import perform
from zbot.package import package_share


def started(
    package: str, file: str, given: dict[str, str], context: LaunchContext | None = None
) -> dict[str, list[str]]:
    """Return the arguments of the nodes that a launch file starts, by their programs."""
    context = context or LaunchContext()
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
    assert started("nav2_bringup", "rviz_launch.py", {}) == {"rviz2": ["-d", usual]}
    given = {"namespace": "", "use_namespace": "False", "rviz_config": "/a.rviz"}
    assert started("nav2_bringup", "rviz_launch.py", given) == {"rviz2": ["-d", "/a.rviz"]}


@pytest.mark.parametrize(
    ("model", "found"),
    [
        ("bot.urdf", "{here}/bot.urdf"),
        ("urdf/01-myfirst.urdf", "{package}/urdf/01-myfirst.urdf"),
        ("/no/bot.urdf", "/no/bot.urdf"),
        ("no.urdf", "{here}/no.urdf"),
    ],
)
def test_the_lesson_about_urdf_shows_a_file_of_the_folder_or_of_the_package(
    model: str, found: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    tmp_path.joinpath("bot.urdf").touch()
    context = LaunchContext()
    given = {"model": model, "gui": "false"}
    programs = started("urdf_tutorial", "display.launch.py", given, context)
    assert set(programs) == {"robot_state_publisher", "joint_state_publisher", "rviz2"}
    package = package_share("urdf_tutorial")
    assert programs["rviz2"] == ["-d", str(package / "rviz" / "urdf.rviz")]
    path = context.launch_configurations["urdf_package_path"]
    assert Path(path) == Path(found.format(here=tmp_path, package=package)).absolute()
