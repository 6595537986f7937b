"""Tests of xacro in launch files and as a program."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.cli.conftest import MANIFEST
from zbot.errors.installation import pip_install
from zbot.package.zbot_command import find_on_path
from zbot_nodes.description import xacro_program

if TYPE_CHECKING:
    from tests.conftest import Start

ROBOT = """<robot name="tower" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="height" default="1.5"/>
<xacro:include filename="$(find tower_description)/urdf/parts.xacro"/>
<xacro:part name="base" height="$(arg height)"/></robot>"""
PARTS = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="part" params="name height">
  <link name="${name}_${float(height) * 2}"/></xacro:macro>
</robot>"""
LAUNCH = """
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import Command, FindExecutable, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare
def generate_launch_description():
    path = PathJoinSubstitution([FindPackageShare("tower_description"), "urdf", "tower.xacro"])
    return LaunchDescription([
        LogInfo(msg=Command(["xacro ", path])),
        LogInfo(msg=Command([FindExecutable(name="xacro"), " ", path, " height:=4"])),
    ])
"""


@pytest.fixture
def tower(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder of a package with a description. No environment is active."""
    folder = tmp_path / "src" / "tower_description"
    (folder / "urdf").mkdir(parents=True)
    manifest = MANIFEST.format(name=folder.name, more="", build_type="ament_cmake")
    (folder / "package.xml").write_text(manifest)
    (folder / "urdf" / "tower.xacro").write_text(ROBOT)
    (folder / "urdf" / "parts.xacro").write_text(PARTS)
    monkeypatch.setenv("PATH", "/usr/bin:/bin")
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return folder


@pytest.mark.usefixtures("tower")
def test_a_launch_file_runs_xacro(start: Start, tmp_path: Path) -> None:
    pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    (tmp_path / "a.launch.py").write_text(LAUNCH)
    program = start("zbot", "launch", "a.launch.py")
    assert program.wait() == 0
    assert '<link name="base_3.0"/>' in program.output
    assert '<link name="base_8.0"/>' in program.output


@pytest.mark.usefixtures("tower")
def test_a_package_that_is_not_found_is_named(start: Start, tmp_path: Path, tower: Path) -> None:
    pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    path = tower / "urdf" / "tower.xacro"
    path.write_text(ROBOT.replace("tower_description", "towr_description"))
    (tmp_path / "a.launch.py").write_text(LAUNCH)
    program = start("zbot", "launch", "a.launch.py")
    assert program.wait() == 1
    assert "package 'towr_description' not found" in program.output


WRONG_PATH = """
import xacro
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import Command
def generate_launch_description():
    return LaunchDescription([LogInfo(msg=OUTPUT)])
"""


@pytest.mark.usefixtures("tower")
@pytest.mark.parametrize("output", ["xacro.process('no.xacro')", "Command('xacro no.xacro')"])
def test_a_wrong_path_is_named(start: Start, tmp_path: Path, output: str) -> None:
    pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    (tmp_path / "a.launch.py").write_text(WRONG_PATH.replace("OUTPUT", output))
    program = start("zbot", "launch", "a.launch.py")
    assert program.wait() == 1
    assert "No such file or directory: ./no.xacro" in program.output
    assert "Traceback" not in program.output


def test_without_the_extra_a_sentence_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, start: Start
) -> None:
    monkeypatch.setitem(sys.modules, "xacro", None)
    with pytest.raises(SystemExit, match=r'installed: .* -m pip install "zbot\[robot\]"'):
        xacro_program.main()
    (tmp_path / "xacro.py").write_text("raise ModuleNotFoundError(name='xacro')")
    (tmp_path / "a.launch.py").write_text("import xacro")
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:{__import__('os').environ['PYTHONPATH']}")
    program = start("zbot", "launch", "a.launch.py")
    assert program.wait() == 1
    assert f"({pip_install('zbot[robot]')})" in program.output


def test_the_own_xacro_is_preferred(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    foreign = tmp_path / "xacro"
    foreign.write_text("#!/bin/sh\n")
    foreign.chmod(0o755)
    environment = {"PATH": str(tmp_path)}
    monkeypatch.setattr("importlib.util.find_spec", lambda _: object())
    found = find_on_path("xacro", environment)
    assert found is not None
    assert "run xacro xacro" in Path(found).read_text(encoding="utf-8")
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    assert find_on_path("xacro", environment) == str(foreign)


@pytest.mark.usefixtures("tower")
def test_the_launch_files_of_urdf_launch_show_a_description(start: Start) -> None:
    pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    pytest.importorskip("viser", reason="an extra: pip install 'zbot[view]'")
    arguments = ("urdf_package:=tower_description", "urdf_package_path:=urdf/tower.xacro")
    program = start("zbot", "launch", "urdf_launch", "display.launch.py", *arguments)
    program.wait_for("Robot initialized")
    program.see("[joint_state_publisher_gui-2]: process started")
    program.wait_for("[rviz2]: zbot view: http://", 30)
    assert program.stop() == 0
