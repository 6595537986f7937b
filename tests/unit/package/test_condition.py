"""Tests of conditions in a package.xml."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.package.condition import ConditionError, holds
from zbot.package.manifest import ManifestError, read_manifest

if TYPE_CHECKING:
    from pathlib import Path

MANIFEST = """\
<package format="3"><name>arm</name><version>0.0.1</version><description>
<p><b>Moves</b> an arm.</p></description><license>MIT</license>
<maintainer email="a@b.c">a</maintainer>
<depend condition="$ROS_VERSION == 1">roscpp</depend>
<depend condition="$ROS_VERSION == 2">rclpy</depend>
<depend>std_msgs</depend>
<member_of_group condition="$ROS_VERSION == 2">rosidl_interface_packages</member_of_group>
<export>
<build_type condition="$ROS_VERSION == 1">catkin</build_type>
<build_type condition="$ROS_VERSION == 2">ament_python</build_type>
</export></package>
"""


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("$ROS_VERSION == 2", True),
        ("$ROS_VERSION==1", False),
        ("2 == $ROS_VERSION", True),
        ("$ROS_DISTRO >= humble", True),
        ("$ROS_DISTRO < humble", False),
        ("$ROS_DISTRO != \"foxy\" and $ROS_PYTHON_VERSION == '3'", True),
        ("$ROS_VERSION == 1 or $ROS_VERSION == 2 and $MY_ROBOT == ''", True),
        ("($ROS_VERSION == 1 or $ROS_VERSION == 2) and $MY_ROBOT == arm", False),
        ("( ( a_b-c == a_b-c ) )", True),
    ],
)
def test_a_condition_compares_texts(condition: str, expected: bool) -> None:
    assert holds(condition) is expected


def test_a_condition_uses_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DISTRO", "foxy")
    assert holds("$ROS_DISTRO == foxy")


@pytest.mark.parametrize(
    "condition",
    ["", "a", "a ==", "== a", "a == b c", "(a == b", "a == b)", "a = b", "a == b and", "a == '",
     "(" * 900, "a" * 1001],
)  # fmt: skip
def test_a_wrong_condition_is_an_error(condition: str) -> None:
    with pytest.raises(ConditionError):
        holds(condition)


def test_elements_whose_condition_is_false_do_not_count(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(MANIFEST)
    manifest = read_manifest(tmp_path / "package.xml")
    assert manifest.build_type == "ament_python"
    assert manifest.named() == {"rclpy", "std_msgs"}
    assert manifest.groups == ("rosidl_interface_packages",)
    (tmp_path / "package.xml").write_text(MANIFEST.replace("== 1", "= 1"))
    with pytest.raises(ManifestError, match=r"package\.xml:4: the condition '\$ROS_VERSION = 1'"):
        read_manifest(tmp_path / "package.xml")


def test_text_in_markup_is_the_text_of_a_description(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(MANIFEST)
    assert read_manifest(tmp_path / "package.xml").name == "arm"
    (tmp_path / "package.xml").write_text(MANIFEST.replace("Moves</b> an arm.", "</b>"))
    with pytest.raises(ManifestError, match="<description> is missing or empty"):
        read_manifest(tmp_path / "package.xml")
