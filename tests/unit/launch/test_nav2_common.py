from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
import yaml

from zbot.launch import LaunchContext
from zbot.launch.condition import IfCondition
from zbot.launch.errors import SubstitutionError
from zbot.launch.substitutions import LaunchConfiguration, TextSubstitution
from zbot.launch.substitutions.nav2_common import (
    HasNodeParams,
    LaunchConfigAsBool,
    ParseMultiRobotPose,
    ReplaceString,
    RewrittenYaml,
)

if TYPE_CHECKING:
    from collections.abc import Iterator

FILE = """
amcl:
  ros__parameters:
    use_sim_time: false
    alpha: 0.2
    frames: [odom, <ns>_base]
    scan: {topic: /scan, use_sim_time: no}
"""


@pytest.fixture
def context() -> Iterator[LaunchContext]:
    made = LaunchContext()
    made.launch_configurations["sim"] = "True"
    yield made
    made.close()


@pytest.fixture
def path(tmp_path: Path) -> str:
    (tmp_path / "nav.yaml").write_text(FILE)
    return str(tmp_path / "nav.yaml")


@pytest.mark.parametrize(
    ("options", "where", "expected"),
    [
        ({"param_rewrites": {"use_sim_time": LaunchConfiguration("sim")}}, "use_sim_time", True),
        ({"param_rewrites": {"use_sim_time": "true"}}, "scan use_sim_time", True),
        ({"param_rewrites": ""}, "alpha", 0.2),
        ({"param_rewrites": {"alpha": "3.5"}}, "alpha", "3.5"),
        ({"param_rewrites": {"alpha": "3.5"}, "convert_types": True}, "alpha", 3.5),
        ({"param_rewrites": {"frames": "none"}}, "frames", "none"),
        ({"param_rewrites": {"amcl.ros__parameters.scan.topic": "/s"}}, "scan topic", "/s"),
        ({"param_rewrites": {"amcl.ros__parameters.frames.0": "/o"}}, "frames 0", "/o"),
        ({"param_rewrites": {"amcl.ros__parameters.new.one": "1"}}, "new one", "1"),
        ({"param_rewrites": {}, "key_rewrites": {"scan": "laser"}}, "laser topic", "/scan"),
        ({"param_rewrites": {}, "value_rewrites": {"0.2": "4"}, "convert_types": True}, "alpha", 4),
        ({"param_rewrites": {}, "value_rewrites": {"odom": "o"}}, "frames 0", "o"),
    ],
)
def test_a_copy_of_the_file_has_new_values(
    context: LaunchContext, path: str, options: Any, where: str, expected: Any
) -> None:
    copy = RewrittenYaml(source_file=path, root_key="robot", **options).perform(context)
    value = yaml.safe_load(Path(copy).read_text())["robot"]["amcl"]["ros__parameters"]
    for key in where.split():
        value = value[int(key) if key.isdigit() else key]
    assert value == expected


def test_an_empty_key_adds_no_level(context: LaunchContext, path: str) -> None:
    copy = RewrittenYaml(path, {}, root_key="").perform(context)
    assert yaml.safe_load(Path(copy).read_text()) == yaml.safe_load(FILE)


def test_an_unknown_parameter_is_added_only_by_its_whole_path(
    context: LaunchContext, path: str
) -> None:
    rewritten = RewrittenYaml(path, {"beta": "1", "amcl.beta": "1"}, convert_types=True)
    assert yaml.safe_load(Path(rewritten.perform(context)).read_text()) == yaml.safe_load(FILE)


def test_the_copy_is_in_the_given_folder_until_the_launch_ends(
    context: LaunchContext, path: str, tmp_path: Path
) -> None:
    copy = Path(RewrittenYaml(path, {}, out_dir=str(tmp_path)).perform(context))
    assert (copy.parent, copy.exists()) == (tmp_path, True)
    context.close()
    assert not copy.exists()


@pytest.mark.parametrize(
    ("text", "reason"), [("- a", "no names with values"), ("a: [", "line 1"), (None, "cannot read")]
)
def test_a_file_that_has_no_parameters_is_named(
    context: LaunchContext, tmp_path: Path, text: str | None, reason: str
) -> None:
    path = tmp_path / "wrong.yaml"
    if text is not None:
        path.write_text(text)
    with pytest.raises(SubstitutionError, match=rf"wrong\.yaml.*{reason}|{reason}.*wrong\.yaml"):
        RewrittenYaml(str(path), {}).perform(context)


@pytest.mark.parametrize(("text", "base"), [("true", "r1_base"), ("false", "<ns>_base")])
def test_texts_are_replaced_if_the_condition_is_true(
    context: LaunchContext, path: str, text: str, base: str
) -> None:
    value: list[Any] = [TextSubstitution(text="r"), "1"]
    replaced = ReplaceString(path, {"<ns>": value}, condition=IfCondition(text))
    assert base in Path(replaced.perform(context)).read_text()


@pytest.mark.parametrize(("node", "expected"), [("amcl", "True"), ("planner", "False")])
def test_the_section_of_a_node_is_found(
    context: LaunchContext, path: str, node: str, expected: str
) -> None:
    assert HasNodeParams(source_file=path, node_name=node).perform(context) == expected


@pytest.mark.parametrize(
    ("text", "expected"), [(" Yes ", "True"), ("1", "True"), ("off", "False"), ("x", "False")]
)
def test_a_launch_argument_becomes_a_truth_value(
    context: LaunchContext, text: str, expected: str
) -> None:
    context.launch_configurations["flag"] = text
    assert LaunchConfigAsBool("flag").perform(context) == expected


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("robots:=a={x: 1.0, yaw: 2.0}; b={}", {"a": (1.0, 2.0), "b": (0.0, 0.0)}),
        ("other:=a={x: 1.0}", {}),
        ("robots:=", {}),
    ],
)
def test_poses_of_robots_are_read_from_the_command_line(
    monkeypatch: pytest.MonkeyPatch, word: str, expected: dict[str, tuple[float, float]]
) -> None:
    monkeypatch.setattr(sys, "argv", ["zbot", "launch", "robots.launch.py", word])
    poses = ParseMultiRobotPose("robots").value()
    assert {name: (pose["x"], pose["yaw"]) for name, pose in poses.items()} == expected
    assert all(len(pose) == 6 for pose in poses.values())


def test_a_pose_that_is_no_dictionary_is_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["zbot", "launch", "x.launch.py", "robots:=a=1.0"])
    with pytest.raises(SubstitutionError, match=r"a pose must look like \{x: 1\.0.*not '1\.0'"):
        ParseMultiRobotPose("robots").value()
