"""Tests of the workspaces in which packages are found."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

import pytest

from zbot.interfaces.location import package_folder
from zbot.package import (
    package_share,
)
from zbot.package.workspace import (
    current_workspace,
    package_folders,
    packages_by_name,
    set_workspace_variable,
)

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

from tests.unit.package.conftest import MANIFEST


def test_a_process_can_keep_its_workspace(
    write: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write()
    monkeypatch.setenv("ZBOT_WORKSPACE", "")
    set_workspace_variable(tmp_path)
    monkeypatch.chdir(tmp_path)
    assert package_share("robot") == folder


def test_the_workspace_of_a_program_is_used_from_any_folder(
    write: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write("robot/drive.py")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ZBOT_WORKSPACE", "")
    set_workspace_variable(folder / "robot")
    assert os.environ["ZBOT_WORKSPACE"] == str(folder.parent)


def test_a_program_finds_packages_beside_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = _packages_beside_each_other(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ZBOT_WORKSPACE", "")
    set_workspace_variable(robot)
    monkeypatch.chdir(robot / "robot")
    assert sorted(packages_by_name()) == ["arm", "robot"]
    assert package_folder("robot_words") == tmp_path / "robot_words"


def test_a_package_finds_the_packages_of_its_repository(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = _packages_beside_each_other(tmp_path)
    monkeypatch.chdir(robot / "robot")
    assert sorted(packages_by_name()) == ["robot"]  # other packages may lie beside it by chance
    (tmp_path / ".git").mkdir()
    assert sorted(packages_by_name()) == ["arm", "robot"]
    assert package_folder("robot_words") == tmp_path / "robot_words"
    assert [folder for folder, _ in current_workspace()] == [robot]


def test_packages_are_found_two_folders_below_the_root_of_a_repository(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = _packages_beside_each_other(tmp_path / "sources")
    monkeypatch.chdir(tmp_path)
    assert sorted(packages_by_name()) == []
    (tmp_path / ".git").mkdir()
    assert sorted(packages_by_name()) == ["arm", "robot"]
    monkeypatch.chdir(robot / "robot")
    assert sorted(packages_by_name()) == ["arm", "robot"]
    assert package_folder("robot_words") == tmp_path / "sources" / "robot_words"


def _packages_beside_each_other(folder: Path) -> Path:
    """Write packages without a folder `src`, and return the folder of the package `robot`."""
    for name in ("arm", "robot"):
        (folder / name / name).mkdir(parents=True)
        (folder / name / "package.xml").write_text(MANIFEST.format(name))
    (folder / "robot_words" / "msg").mkdir(parents=True)
    (folder / "robot_words" / "msg" / "Word.msg").write_text("string data\n")
    return folder / "robot"


def test_a_workspace_given_by_a_variable_is_the_only_one(
    write: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_WORKSPACE", "/named")
    set_workspace_variable(write())
    assert os.environ["ZBOT_WORKSPACE"] == "/named"


def test_a_package_around_its_workspace_is_found_once(
    write: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    inner = write()
    outer = inner.parents[1]
    (outer / "package.xml").write_text(MANIFEST.format("outer"))
    assert sorted(package_folders()) == [outer, inner]
    monkeypatch.setenv("ZBOT_WORKSPACE", "")
    set_workspace_variable(outer)
    assert sorted(package_folders()) == [outer, inner]


@pytest.mark.parametrize(
    ("text", "is_package"),
    [
        ("[project]\nname = 'arm'\n", True),
        ("project.name = 'arm'\n", True),
        ("project = {name = 'arm'}\n", True),
        ("[project\nname = 'arm'\n", True),  # its commands name the error
        ("[tool.ruff]\ninclude = ['[project]']\n", False),
        ("# [project]\n", False),
        ("project = 1\n", False),
    ],
)
def test_a_pyproject_with_a_project_is_a_package(
    text: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    *,
    is_package: bool,
) -> None:
    (tmp_path / "arm").mkdir()
    (tmp_path / "arm" / "pyproject.toml").write_text(text)
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path))
    assert list(package_folders()) == ([tmp_path / "arm"] if is_package else [])


def test_the_pyproject_of_a_repository_is_no_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arm, hand = tmp_path / "robots" / "arm", tmp_path / "robots" / "arm" / "hand"
    hand.mkdir(parents=True)
    (arm / "pyproject.toml").write_text("[project]\nname = 'arm'\n")
    (hand / "package.xml").write_text("<package><name>arm</name></package>")
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path))
    assert list(package_folders()) == [hand]
    (arm / "setup.py").touch()
    assert list(package_folders()) == [arm, hand]


@pytest.mark.parametrize("name", ["AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE"])
def test_a_file_hides_the_packages_of_a_folder(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "robots" / "arm"
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>arm</name></package>")
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path))
    assert list(package_folders()) == [folder]
    (folder.parent / name).touch()
    assert list(package_folders()) == []


@pytest.mark.skipif(sys.platform == "win32", reason="needs the right to make links")
def test_a_linked_repository_is_found_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder, source = tmp_path / "elsewhere" / "arm", tmp_path / "ws" / "src"
    folder.mkdir(parents=True)
    source.mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>arm</name></package>")
    (folder.parent / "circle").symlink_to(folder.parent)
    (source / "robots").symlink_to(folder.parent)
    (source / "twice").symlink_to(folder)
    (source / "broken").symlink_to(tmp_path / "nowhere")
    monkeypatch.setenv("ZBOT_WORKSPACE", str(source))
    (found,) = package_folders()
    assert found.samefile(folder)
    assert found.is_relative_to(source)


@pytest.mark.parametrize("manifest", ["", "src/robots/arm/package.xml", "install/setup.bash"])
def test_a_folder_src_of_checkouts_is_no_workspace(
    manifest: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("tool", "other"):
        (tmp_path / "src" / name).mkdir(parents=True)
        (tmp_path / "src" / name / "pyproject.toml").write_text(f"[project]\nname = '{name}'\n")
    if manifest:
        (tmp_path / manifest).parent.mkdir(parents=True)
        (tmp_path / manifest).write_text(MANIFEST.format("arm"))
    monkeypatch.chdir(tmp_path / "src" / "tool")
    assert ("other" in packages_by_name()) == bool(manifest)
    assert "tool" in packages_by_name()
