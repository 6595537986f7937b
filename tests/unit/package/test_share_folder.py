"""Tests of the share folders of packages, which are links to their sources."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from zbot.package import (
    package_prefix,
    package_share,
)
from zbot.package.symlink_install import SymlinkInstallError

if TYPE_CHECKING:
    from collections.abc import Callable


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


def test_a_prefix_has_the_programs_of_setup_py(write: Callable[..., Path]) -> None:
    folder = write("scripts/wave", setup="(os.path.join('lib', name), ['scripts/wave'])")
    setup = folder / "setup.py"
    scripts = "entry_points={'console_scripts': ['drive = robot.drive:main']}, data_files"
    setup.write_text(setup.read_text().replace("data_files", scripts))
    programs = package_prefix("robot") / "lib" / "robot"
    assert (programs / "wave").read_text() == "scripts/wave"
    wrapper = shutil.which(programs / "drive")
    assert wrapper is not None
    assert "run robot drive" in Path(wrapper).read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("package", "program"),
    [("xacro", "xacro"), ("rviz2", "rviz2"), ("rqt_gui", "rqt"), ("gazebo", "gzserver")],
)
def test_a_bundled_prefix_has_the_programs_that_ros2_has_on_the_path(
    package: str, program: str
) -> None:
    path = shutil.which(package_prefix(package) / "bin" / program)
    assert path is not None
    assert f"run {package} {program}" in Path(path).read_text(encoding="utf-8")
    assert not (package_prefix("turtlesim") / "bin").exists()


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
