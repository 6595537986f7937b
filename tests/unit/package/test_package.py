"""Tests of the search for packages, of their share folders and of workspaces."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from zbot.interfaces.location import package_folder
from zbot.package import (
    PackageNameError,
    PackageNotFoundError,
    package_prefix,
    package_share,
    packages,
)
from zbot.package.finder import Origin, all_packages, find_package
from zbot.package.symlink_install import SymlinkInstallError
from zbot.package.user_folders import cache_folder, home_folder
from zbot.package.workspace import (
    current_workspace,
    package_folders,
    packages_by_name,
    set_workspace_variable,
)

if TYPE_CHECKING:
    from collections.abc import Callable

MANIFEST = "<package><name>{}</name></package>"
SETUP = "from glob import glob\nname = 'robot'\nsetup(name=name, data_files=[{}])\n"


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Path]:
    """Return a function that writes a package into a workspace around the current folder."""
    source = tmp_path / "ws" / "src"
    source.mkdir(parents=True)
    monkeypatch.chdir(source.parent)

    def make(*files: str, name: str = "robot", setup: str = "", cmake: str = "") -> Path:
        folder = source / name
        for file in files:
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_text(file)
        folder.mkdir(exist_ok=True)
        (folder / "package.xml").write_text(MANIFEST.format(name))
        if setup:
            (folder / "setup.py").write_text(SETUP.format(setup))
        if cmake:
            (folder / "CMakeLists.txt").write_text(cmake)
        return folder

    return make


# -- finding -------------------------------------------------------------------------------------


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


@pytest.mark.parametrize("name", ["", "../robot", "a/b", "x", "-robot", "ro bot", "robot\n"])
def test_an_invalid_name_is_refused(name: str) -> None:
    with pytest.raises(PackageNameError, match="is not a valid package name"):
        package_share(name)


# -- share folders of links ----------------------------------------------------------------------


def _listed(share: Path) -> dict[str, str]:
    return {
        file.relative_to(share).as_posix(): file.read_text()
        for file in share.rglob("*")
        if file.is_file() and file.name not in {"package.xml", "setup.py", "CMakeLists.txt"}
    }


@pytest.mark.parametrize(
    ("setup", "shared"),
    [
        ("('share/robot', glob('launch/*'))", {"a.launch.py": "launch/a.launch.py"}),
        ("('share/robot/launch', glob('starts/*'))", {"launch/s.launch.py": "starts/s.launch.py"}),
        (
            "('share/robot//launch/', glob('starts/*'))",
            {"launch/s.launch.py": "starts/s.launch.py"},
        ),
        ("('share/robot/../../x', glob('starts/*')), ('/etc', glob('starts/*'))", {}),
    ],
)
def test_files_have_the_places_of_setup_py(
    write: Callable[..., Path], setup: str, shared: dict[str, str]
) -> None:
    write("launch/a.launch.py", "starts/s.launch.py", "left/out.yaml", setup=setup)
    whole = {name: name for name in ("launch/a.launch.py", "starts/s.launch.py", "left/out.yaml")}
    kept = {name: text for name, text in whole.items() if text not in shared.values()}
    assert _listed(package_share("robot")) == {**kept, **shared}


def test_files_have_the_places_of_cmake(write: Callable[..., Path]) -> None:
    write(
        "launch/a.launch.py",
        "models/box/model.sdf",
        "old.yaml",
        "scripts/node.py",
        cmake="""
            project(robot)  # install(FILES nothing DESTINATION share/robot)
            set(WHERE share/${PROJECT_NAME})
            install(DIRECTORY launch DESTINATION ${WHERE}/)
            install(DIRECTORY models/ DESTINATION "${WHERE}")
            install(FILES old.yaml DESTINATION ${WHERE}/config RENAME new.yaml)
            install(PROGRAMS scripts/node.py DESTINATION lib/${PROJECT_NAME})
        """,
    )
    assert _listed(package_share("robot")) == {
        "launch/a.launch.py": "launch/a.launch.py",
        "box/model.sdf": "models/box/model.sdf",
        "config/new.yaml": "old.yaml",
        "scripts/node.py": "scripts/node.py",
    }
    assert (package_prefix("robot") / "lib" / "robot" / "node.py").read_text() == "scripts/node.py"


@pytest.mark.parametrize(
    ("build_type", "place"),
    [("ament_python", "by_python"), ("ament_cmake", "by_cmake"), ("", "both")],
)
def test_the_build_type_decides_between_two_build_files(
    write: Callable[..., Path], build_type: str, place: str
) -> None:
    folder = write(
        "start/a.launch.py",
        setup="('share/robot/by_python', glob('start/*'))",
        cmake="install(FILES start/a.launch.py DESTINATION share/robot/by_cmake)",
    )
    manifest = (folder / "package.xml").read_text()
    export = f"<export><build_type>{build_type}</build_type></export></package>"
    (folder / "package.xml").write_text(manifest.replace("</package>", export))
    listed = _listed(package_share("robot"))
    places = {"by_python", "by_cmake"} if place == "both" else {place}
    assert set(listed) == {f"{one}/a.launch.py" for one in places}


def test_links_follow_the_sources(write: Callable[..., Path]) -> None:
    folder = write("launch/a.launch.py", "config/x", setup="('share/robot', glob('launch/*'))")
    share = package_share("robot")
    (folder / "launch" / "a.launch.py").write_text("changed")
    assert (share / "a.launch.py").read_text() == "changed"
    (folder / "launch" / "a.launch.py").unlink()
    (folder / "launch" / "b.launch.py").write_text("b")
    shutil.rmtree(folder / "config")
    (folder / "config").write_text("a file now")
    assert _listed(package_share("robot")) == {"b.launch.py": "b", "config": "a file now"}
    assert (folder / "launch" / "b.launch.py").read_text() == "b"


def test_sources_are_never_deleted_with_their_links(write: Callable[..., Path]) -> None:
    folder = write("launch/a.launch.py", setup="('share/robot', glob('launch/*'))")
    assert package_share("robot") != folder
    write(setup="('share/robot/launch', glob('launch/*'))")
    assert package_share("robot") == folder
    assert (folder / "launch" / "a.launch.py").is_file()


def test_two_workspaces_have_their_own_links(
    write: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write("launch/a.launch.py", setup="('share/robot', glob('launch/*'))")
    first = package_share("robot")
    shutil.copytree(folder, tmp_path / "other" / "src" / "robot")
    monkeypatch.chdir(tmp_path / "other")
    assert package_share("robot") != first


def test_a_prefix_has_the_share_folder(write: Callable[..., Path]) -> None:
    write("launch/a.launch.py")
    assert _listed(package_prefix("robot") / "share" / "robot") == {
        "launch/a.launch.py": "launch/a.launch.py"
    }
    assert (package_prefix("std_msgs") / "share" / "std_msgs" / "msg" / "String.msg").is_file()


def test_links_need_no_privileges_on_windows(
    write: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise OSError

    write("launch/a.launch.py", setup="('share/robot', glob('launch/*'))")
    monkeypatch.setattr(Path, "symlink_to", refuse)
    assert (package_share("robot") / "a.launch.py").read_text() == "launch/a.launch.py"
    monkeypatch.setattr(Path, "hardlink_to", refuse)
    write("launch/b.launch.py")
    assert (package_share("robot") / "b.launch.py").read_text() == "launch/b.launch.py"


def test_an_unwritable_cache_is_reported(write: Callable[..., Path], cache: Path) -> None:
    write("launch/a.launch.py", setup="('share/robot', glob('launch/*'))")
    cache.write_text("no folder")
    with pytest.raises(SymlinkInstallError, match=r"cannot link the files of robot .*: Not a dir"):
        package_share("robot")


@pytest.mark.parametrize(
    ("platform", "folder"),
    [("linux", "cache/zbot"), ("darwin", "Library/Caches/zbot"), ("win32", "local/zbot")],
)
def test_each_system_has_its_own_cache_folder(
    platform: str, folder: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "local"))
    assert cache_folder() == tmp_path / folder


@pytest.mark.skipif(sys.platform == "win32", reason="the folder has another name there")
def test_a_user_without_a_home_gets_a_folder_among_the_temporary_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_home() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(Path, "home", no_home)
    folder = tmp_path / f"zbot-{os.getuid()}"
    assert home_folder() == folder
    assert folder.stat().st_mode & 0o777 == 0o700
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    (tmp_path / "zbot-12345").mkdir()
    with pytest.raises(PermissionError, match="belongs to another user"):
        home_folder()


@pytest.mark.skipif(sys.platform == "win32", reason="the folder has another name there")
def test_a_cache_that_cannot_be_written_is_among_the_temporary_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setenv("HOME", str(tmp_path / "missing"))
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(os, "access", lambda path, _: path != tmp_path)
    assert cache_folder() == tmp_path / f"zbot-{os.getuid()}"


# -- workspaces ----------------------------------------------------------------------------------


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
