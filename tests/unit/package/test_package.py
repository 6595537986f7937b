"""Tests of the search for packages."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

import pytest

from zbot.package import (
    PackageNameError,
    PackageNotFoundError,
    package_prefix,
    package_share,
    packages,
)
from zbot.package.finder import Origin, all_packages, find_package

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


def test_the_share_folder_of_a_source_package_is_its_folder(write: Callable[..., Path]) -> None:
    folder = write("launch/a.launch.py")
    assert package_share("robot") == folder


def test_a_package_whose_files_keep_their_names_needs_no_links(
    write: Callable[..., Path], cache: Path
) -> None:
    folder = write(
        "launch/a.launch.py",
        "config/b.yaml",
        setup="('share/ament_index/resource_index/packages', ['resource/robot']),"
        "('share/robot', ['package.xml']), ('share/' + name + '/launch', glob('launch/*')),"
        "('share/robot/config', glob('config/*.yaml')), ('lib/robot', glob('scripts/*'))",
    )
    assert package_share("robot") == folder
    assert not cache.exists()


def test_a_package_of_the_workspace_hides_a_bundled_one(write: Callable[..., Path]) -> None:
    folder = write("launch/a.launch.py", name="std_msgs")
    assert package_share("std_msgs") == folder


def test_bundled_interface_packages_are_found() -> None:
    assert (package_share("std_msgs") / "msg" / "String.msg").is_file()
    assert packages()["std_msgs"].origin is Origin.BUNDLED


def test_the_share_folder_of_zbot_has_launch_files_only() -> None:
    share = package_share("zbot_nodes")
    assert {entry.name for entry in share.glob("*")} == {"launch"}
    assert all(entry.is_file() for entry in share.glob("launch/*"))


def test_names_for_the_same_files_have_share_folders_of_their_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)  # a checkout in a folder `zbot` is itself a package of this name
    files = list(package_share("zbot").glob("launch/*"))
    assert package_share("zbot_nodes").name == "zbot_nodes"
    assert files
    assert all(file.is_file() for file in files)


def test_a_prefix_of_ros_2_is_searched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    index = tmp_path / "ros" / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "rover").touch()
    (tmp_path / "ros" / "share" / "rover").mkdir()
    monkeypatch.setenv("AMENT_PREFIX_PATH", f"{tmp_path / 'nowhere'}{os.pathsep}{tmp_path / 'ros'}")
    assert package_share("rover") == tmp_path / "ros" / "share" / "rover"
    assert package_prefix("rover") == tmp_path / "ros"


def test_packages_of_pip_are_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    share = tmp_path / "share" / "robot"
    share.mkdir(parents=True)
    (share / "package.xml").touch()
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    assert package_share("robot") == share
    assert "robot" in all_packages()


def test_an_installed_python_package_with_launch_files_is_its_own_share_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "robot" / "launch").mkdir(parents=True)
    (tmp_path / "robot" / "__init__.py").touch()
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "__init__.py").touch()
    monkeypatch.syspath_prepend(str(tmp_path))
    assert package_share("robot") == tmp_path / "robot"
    assert find_package("other") is None


def test_an_editable_package_has_the_folder_of_its_sources(
    write: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write("launch/a.launch.py")
    info = tmp_path / "site" / "robot-0.1.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: robot\nVersion: 0.1\n")
    origin = f'{{"url": "{folder.as_uri()}", "dir_info": {{"editable": true}}}}'
    (info / "direct_url.json").write_text(origin)
    monkeypatch.syspath_prepend(str(tmp_path / "site"))
    monkeypatch.chdir(tmp_path / "site")
    assert package_share("robot") == folder


def test_an_unknown_package_is_refused_with_the_nearest_name(write: Callable[..., Path]) -> None:
    source = write().parent
    with pytest.raises(PackageNotFoundError) as caught:
        package_share("robott")
    assert str(caught.value).startswith(f"package 'robott' not found, searching: ['{source}', ")
    assert caught.value.hint == "did you mean 'robot'?"
    with pytest.raises(KeyError):
        package_prefix("nothing_like_it")


@pytest.mark.parametrize("name", ["robotino_description", "fbot_navigation", "fbot_hri_bringup"])
def test_a_name_that_only_ends_like_another_one_has_no_nearest_name(
    name: str, write: Callable[..., Path]
) -> None:
    write(name="fbot_bringup")
    with pytest.raises(PackageNotFoundError) as caught:
        package_share(name)
    assert caught.value.hint == f"put the sources of {name} into the folder src of your workspace"


@pytest.mark.parametrize("name", ["", "../robot", "a/b", "x", "-robot", "ro bot", "robot\n"])
def test_an_invalid_name_is_refused(name: str) -> None:
    with pytest.raises(PackageNameError, match="is not a valid package name"):
        package_share(name)
