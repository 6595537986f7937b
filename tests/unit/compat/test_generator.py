"""Tests of the modules that are written from the table of ROS 2's names."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import pytest

import zbot.compat
import zbot.launch.log
from zbot.compat.generator import main, package_files, write_packages
from zbot.compat.table import Module, modules

PACKAGES = Path(zbot.compat.__file__).parent / "packages"


def test_the_modules_in_the_repository_match_the_table() -> None:
    actual = {
        file.relative_to(PACKAGES).as_posix(): file.read_text(encoding="utf-8")
        for file in PACKAGES.rglob("*")
        if file.is_file() and file.suffix != ".pyc"
    }
    assert actual == package_files(), "run: python -m zbot.compat.generator zbot/compat/packages"


@pytest.mark.parametrize("name", modules())
def test_every_module_has_the_names_of_the_table(name: str) -> None:
    module = importlib.import_module(name)
    assert [
        public_name for public_name in modules()[name].names if not hasattr(module, public_name)
    ] == []


@pytest.mark.parametrize(
    "line",
    [
        "from tf2_ros import Duration, Node, PointStamped, Time, TransformStamped",
        "from tf2_ros.buffer import Buffer, Duration, TransformStamped",
        "from tf2_ros.transform_broadcaster import TransformBroadcaster, TransformStamped",
        "from tf2_ros.transform_listener import Buffer, TransformListener",
        "from tf2_geometry_msgs import Pose, PoseStamped, TransformStamped",
        "from message_filters import Duration",
        "from launch.launch_description import DeclareLaunchArgument, LaunchDescription",
        "from launch_ros.actions.node import ExecuteProcess, Node",
    ],
)
def test_names_that_modules_of_ros_2_import_for_themselves_are_in_them(line: str) -> None:
    exec(line)


def test_every_submodule_is_an_attribute_of_its_package() -> None:
    for name in modules():
        package, _, last = name.rpartition(".")
        if package and last not in modules()[package].names:
            module = sys.modules.get(name) or importlib.import_module(name)
            assert getattr(importlib.import_module(package), last) is module


def test_a_module_that_left_the_table_is_removed(tmp_path: Path) -> None:
    write_packages(tmp_path)
    old = tmp_path / "rclpy" / "old.py"
    old.write_text((tmp_path / "rclpy" / "time.py").read_text())
    own = tmp_path / "own.py"
    own.touch()
    assert main([str(tmp_path)]) == 0
    assert (old.exists(), own.exists()) == (False, True)


def test_the_command_without_a_folder_prints_its_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 2
    assert "python -m zbot.compat.generator FOLDER" in capsys.readouterr().err


def test_a_submodule_has_its_names_from_the_places_of_its_package() -> None:
    package = Module("", {"zbot.a": {"A": "A", "B": "Bee"}, "zbot.c": {"C": "C"}})
    assert package.part("", ["B"]).places == {"zbot.a": {"B": "Bee"}}


def test_a_module_that_is_one_of_zbot_is_the_same_object() -> None:
    assert importlib.import_module("launch.logging") is zbot.launch.log
    handlers = importlib.import_module("launch.logging.handlers")
    assert handlers is zbot.launch.log.handlers
