"""Tests of `zbot test` in a workspace: which tests run, and in which processes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tests.cli.command import zbot

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.conftest import Write

PASSES = "def test_it(): pass\n"
LAUNCH = """\
import unittest
from launch import LaunchDescription
from launch_testing.actions import ReadyToTest
from launch_testing.markers import keep_alive

@keep_alive
def generate_test_description():
    return LaunchDescription([ReadyToTest()])

class TestLaunch(unittest.TestCase):
    def test_it(self): pass
"""
CMAKE = """\
project(lift)
if(BUILD_TESTING)
  add_launch_test(test/smoke.test.py)
  ament_add_pytest_test(unit test/check_unit.py)
endif()
"""


def test_tests_of_two_packages_may_have_the_same_name(write: Write, workspace: Path) -> None:
    for name in ("robot", "arm"):
        write(name, **{"test/test_same.py": PASSES, "test/__init__.py": ""})
    for words in ([], ["--packages-select", "robot", "arm"], ["src"]):
        done = zbot("test", *words, cwd=workspace.parent)
        assert done.code == 0, done.out
        assert done.out.count("1 passed") == 2


def test_the_exit_code_is_an_error_if_one_package_fails(write: Write, workspace: Path) -> None:
    write("robot", **{"test/test_a.py": "def test_it(): raise ValueError"})
    write("wheel", **{"test/test_a.py": PASSES})
    write("no_tests")
    done = zbot("test", cwd=workspace.parent)
    assert done.code == 1
    assert "1 failed" in done.out
    assert "1 passed" in done.out
    done = zbot("test", "--packages-select", "wheel", "no_tests", cwd=workspace.parent)
    assert done.code == 0
    assert zbot("test", "--packages-select", "no_tests", cwd=workspace.parent).code == 1


def test_tests_that_only_cmake_adds_run(write: Write, workspace: Path) -> None:
    files = {"CMakeLists.txt": CMAKE, "test/smoke.test.py": LAUNCH, "test/check_unit.py": PASSES}
    folder = write("lift", build_type="ament_cmake", **files)
    for words, cwd in ((["--packages-select", "lift"], workspace.parent), ([], folder)):
        done = zbot("test", *words, cwd=cwd)
        assert done.code == 0, done.err
        assert "1 passed" in done.out
        assert "test_it (smoke_test.TestLaunch" in done.err


def test_tests_of_a_loop_in_cmake_are_the_files_of_the_test_folder(
    write: Write, workspace: Path
) -> None:
    loop = "foreach(path ${paths})\n  ament_add_pytest_test(${path} ${path})\nendforeach()\n"
    files = {"CMakeLists.txt": f"project(lift)\n{loop}", "test/test_unit.py": PASSES}
    write("lift", build_type="ament_cmake", **files)
    assert "1 passed" in zbot("test", cwd=workspace.parent).out


def test_an_error_of_one_package_does_not_end_the_others(write: Write, workspace: Path) -> None:
    empty = "def generate_test_description(): ...\n"
    files = {"CMakeLists.txt": CMAKE, "test/smoke.test.py": empty, "test/check_unit.py": PASSES}
    write("lift", build_type="ament_cmake", **files)
    done = zbot("test", cwd=workspace.parent)
    assert done.code == 1
    assert "1 passed" in done.out
