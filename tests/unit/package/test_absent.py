"""Tests of the folders of well-known packages that are not here, during a launch."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from zbot.package import PackageNotFoundError, package_prefix, package_share
from zbot.package.absent import absent_file, absent_packages_reported
from zbot.package.ament_index import (
    ResourceNotFoundError,
    get_package_share_directory,
    get_packages_with_prefixes,
    get_resource,
    has_resource,
)
from zbot.package.bundled_nodes import BUNDLED_NODES
from zbot.package.unavailable import (
    _BY_EXECUTABLE,
    unavailable_executable,
    unavailable_package,
    unavailable_packages,
)

if TYPE_CHECKING:
    from zbot.package.errors import NotRunnableError

NAME = "stage_ros2"
SHARE = Path(sys.prefix, "share", NAME)


@pytest.fixture(autouse=True)
def empty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.filterwarnings("error")
def test_a_launch_gets_the_folders_of_a_package_that_is_not_here() -> None:
    reports: list[NotRunnableError] = []
    with absent_packages_reported(reports.append):
        assert package_share(NAME) == SHARE
        assert package_prefix(NAME) == Path(sys.prefix)
        assert get_package_share_directory(NAME) == str(SHARE)
        assert get_resource("packages", NAME) == ("", sys.prefix)
        assert get_packages_with_prefixes()[NAME] == sys.prefix
    assert [report.name for report in reports] == [NAME] * 5
    assert not SHARE.exists()


def test_a_question_whether_a_package_is_here_gets_no() -> None:
    with absent_packages_reported():
        assert has_resource("packages", NAME) is False
        assert NAME not in get_packages_with_prefixes()
        assert get_packages_with_prefixes().get(NAME) is None
        with pytest.raises(ResourceNotFoundError):
            get_resource("rosidl_interfaces", NAME)


@pytest.mark.parametrize("name", [NAME, "no_such_package"])
def test_other_programs_get_an_error(name: str) -> None:
    for question in (package_share, package_prefix, get_package_share_directory):
        with pytest.raises(PackageNotFoundError):
            question(name)
    with pytest.raises(ResourceNotFoundError):
        get_resource("packages", name)
    with pytest.raises(KeyError):
        get_packages_with_prefixes()[name]


def test_an_unknown_package_is_an_error_also_during_a_launch() -> None:
    with absent_packages_reported(), pytest.raises(PackageNotFoundError) as caught:
        package_share("nav2_bringp")
    assert caught.value.hint == "did you mean 'nav2_bringup'?"


def test_an_outer_report_is_kept() -> None:
    reports: list[NotRunnableError] = []
    with absent_packages_reported(reports.append), absent_packages_reported():
        package_share(NAME)
    assert len(reports) == 1


@pytest.mark.parametrize(
    ("path", "file"),
    [
        (SHARE / "launch" / "gz_sim.launch.py", "launch/gz_sim.launch.py"),
        (SHARE, ""),
        (str(SHARE / "a"), "a"),
    ],
)
def test_a_path_in_such_a_folder_is_known(path: Path | str, file: str) -> None:
    error = absent_file(path)
    assert error is not None
    assert (error.name, error.file) == (NAME, file)


@pytest.mark.parametrize("path", [SHARE.parent, SHARE.parent / "no_such" / "a", Path("a"), "", "/"])
def test_other_paths_are_not(path: Path | str) -> None:
    assert absent_file(path) is None


def test_a_file_that_a_copy_of_a_package_lacks_is_named_with_the_files_that_it_has() -> None:
    share = package_share("nav2_bringup")
    error = absent_file(share / "launch" / "tb3_simulation_launch.py")
    assert error is not None
    assert error.needed == "launch/tb3_simulation_launch.py of nav2_bringup"
    assert "or use one of bringup_launch.py, localization_launch.py" in error.sentence
    error = absent_file(package_share("slam_toolbox") / "maps" / "a.posegraph")
    assert error is not None
    assert error.sentence.endswith("of slam_toolbox into the folder src of your workspace")


@pytest.mark.parametrize("file", ["launch/bringup_launch.py", "launch/bringup_lanch.py", ""])
def test_a_file_that_is_there_or_has_a_typo_is_none_of_these(file: str) -> None:
    assert absent_file(package_share("nav2_bringup") / file) is None


def test_a_package_of_the_workspace_lacks_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "src" / "nav2_bringup"
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>nav2_bringup</name></package>")
    assert package_share("nav2_bringup") == folder
    assert absent_file(folder / "launch" / "tb3_simulation_launch.py") is None


def test_the_tables_agree() -> None:
    assert {"rclcpp_components", NAME, "ur_description"} <= set(unavailable_packages())
    assert unavailable_executable("demo_nodes_cpp", "talker_loaned_message") is not None
    assert unavailable_executable("demo_nodes_cpp", "talker") is None
    assert unavailable_package("isaac_ros_apriltag") is not None
    assert unavailable_package("isaac_ros_apriltag_interfaces") is None
    assert unavailable_package("isaac") is None
    assert not [key for key in _BY_EXECUTABLE if key[1] in BUNDLED_NODES[key[0]]]


def test_programs_that_the_documentation_calls_left_out_are_in_the_table() -> None:
    page = Path(__file__).parents[3].joinpath("docs", "robot-nodes.md").read_text("utf-8")
    found = set()
    for section in re.split(r"^### ", page, flags=re.MULTILINE):
        package = re.match(r"`(\w+)", section)
        text = " ".join(section.split())
        for names in re.findall(r"\. ((?:`[\w.]+`(?:, | and )?)+) (?:is|are) left out", text):
            assert package is not None
            found |= {(package[1], name) for name in re.findall(r"`([\w.]+)`", names)}
    assert ("twist_mux", "twist_marker") in found
    assert [key for key in sorted(found) if unavailable_executable(*key) is None] == []
