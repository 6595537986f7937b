"""Tests of the reader of CMakeLists.txt."""

from __future__ import annotations

import os
import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed
from zbot.package.cmake_file import Installation, read_cmake
from zbot.package.errors import SetupFileError

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("nodes/a.py", "nodes/b.py", "data/x.yaml", "data/deep/y.yaml"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    return tmp_path


def read(folder: Path, text: str) -> Installation:
    (folder / "CMakeLists.txt").write_text(f"project(robot)\n{text}")
    return read_cmake(folder)


@pytest.mark.parametrize(
    "text",
    [
        "install(PROGRAMS nodes/a.py nodes/b.py DESTINATION lib/robot)",
        "INSTALL( PROGRAMS\n  nodes/a.py # first\n  nodes/b.py\n DESTINATION lib/${PROJECT_NAME} )",
        'install(PROGRAMS "nodes/a.py" "nodes/b.py" DESTINATION "lib/${PROJECT_NAME}/")',
        "set(ALL nodes/a.py nodes/b.py)\ninstall(PROGRAMS ${ALL} DESTINATION lib/robot)",
        "set(ALL nodes/a.py;nodes/b.py)\ninstall(PROGRAMS ${ALL} DESTINATION lib/robot)",
        "set(D nodes)\ninstall(PROGRAMS ${D}/a.py ${D}/b.py DESTINATION lib/robot OPTIONAL)",
        "list(APPEND A nodes/a.py nodes/b.py)\ninstall(PROGRAMS ${A} DESTINATION lib/robot)",
        "file(GLOB ALL nodes/*.py)\ninstall(PROGRAMS ${ALL} DESTINATION lib/robot)",
        "file(GLOB_RECURSE A nodes/*.py)\ninstall(PROGRAMS ${A} DESTINATION lib/robot)",
        "#[[ install(x\n) ]]\ninstall(PROGRAMS nodes/a.py nodes/b.py DESTINATION lib/robot)",
    ],
)
def test_installed_programs_are_found(folder: Path, text: str) -> None:
    found = read(folder, text)
    assert {target: path.name for target, path in found.programs.items()} == {
        "lib/robot/a.py": "a.py",
        "lib/robot/b.py": "b.py",
    }
    assert found.missing == {}


def test_programs_of_an_installed_folder_are_found(folder: Path) -> None:
    (folder / "nodes" / "a.py").chmod(0o755)
    text = "install(DIRECTORY nodes/ DESTINATION lib/${PROJECT_NAME} USE_SOURCE_PERMISSIONS)"
    found = read(folder, text)
    if os.name != "nt":  # where each file counts as a program
        assert {*found.programs, *found.files} == {"lib/robot/a.py", "lib/robot/b.py"}
        assert list(found.programs) == ["lib/robot/a.py"]


def test_a_list_that_grows_without_end_is_refused(folder: Path) -> None:
    loop = "foreach(A " + "a " * 9000 + ")\nlist(APPEND ALL a)\nendforeach()"
    with pytest.raises(SetupFileError, match="its variables are too large"):
        read(folder, loop)


@pytest.mark.parametrize(
    ("text", "files"),
    [
        ("DIRECTORY data DESTINATION share/robot", ["data/deep/y.yaml", "data/x.yaml"]),
        ("DIRECTORY data/ DESTINATION share/robot", ["deep/y.yaml", "x.yaml"]),
        ("FILES data/x.yaml DESTINATION share/robot RENAME z.yaml", ["z.yaml"]),
    ],
)
def test_installed_files_are_found(folder: Path, text: str, files: list[str]) -> None:
    found = read(folder, f"install({text})").files
    assert sorted(target.removeprefix("share/robot/") for target in found) == files


@pytest.mark.parametrize(
    "text",
    [
        "add_executable(drive src/drive.cpp)",
        "ament_auto_add_executable(drive src/drive.cpp)",
        "rclcpp_components_register_node(core PLUGIN a::B EXECUTABLE drive)",
        "add_executable(a x.cpp)\nset_target_properties(a PROPERTIES OUTPUT_NAME drive)",
        "function(program name)\nadd_executable(${name} x.cpp)\nendfunction()\nprogram(drive)",
        "macro(program)\nadd_executable(${ARGN} x.cpp)\nendmacro()\nPROGRAM(drive)",
        "foreach(name drive)\nadd_executable(${name} x.cpp)\nendforeach()",
        "set(ALL drive)\nforeach(name ${ALL})\nadd_executable(${name} x.cpp)\nendforeach()",
        "set(ALL drive)\nforeach(name IN LISTS ALL)\nadd_executable(${name} x.cpp)\nendforeach()",
        "foreach(a drive)\nforeach(b x)\nadd_executable(${a} ${b}.cpp)\nendforeach()\nendforeach()",
    ],
)
def test_compiled_programs_are_found(folder: Path, text: str) -> None:
    assert list(read(folder, text).compiled) == ["drive"]


@pytest.mark.parametrize(
    "text",
    [
        "function(never name)\nadd_executable(drive x.cpp)\nendfunction()",
        "foreach(name ${UNKNOWN})\nadd_executable(${name} x.cpp)\nendforeach()",
        "rclcpp_components_register_nodes(core a::B)",
        "rclcpp_components_register_node(core PLUGIN a::B EXECUTABLE)",
        "command(x)\nblock(x)\nenter(x)\nread(x)",
    ],
)
def test_what_is_no_known_program_is_left_out(folder: Path, text: str) -> None:
    assert read(folder, text).compiled == {}


def test_a_program_has_the_line_that_adds_it(folder: Path) -> None:
    assert read(folder, "\n\nadd_executable(drive x.cpp)").compiled == {"drive": 4}


def test_a_loop_over_unknown_values_is_read_once(folder: Path) -> None:
    loop = "foreach(one ${UNKNOWN})\nament_add_pytest_test(${one} test/${one}.py)\nendforeach()"
    assert read(folder, loop).tests == ["test/${one}.py"]


def test_a_folder_without_the_file_installs_nothing(tmp_path: Path) -> None:
    assert read_cmake(tmp_path) == Installation()


@pytest.mark.parametrize(
    "text",
    [
        "install(",
        "install()",
        "install(PROGRAMS)",
        "install(PROGRAMS nodes/a.py DESTINATION)",
        "install(TARGETS x DESTINATION lib/robot)",
        "install(CODE \"message('hi')\")",
        "set()",
        "set(A ${A})\ninstall(FILES ${A} DESTINATION share/robot)",
        "set(A ${B}x)\nset(B ${A}y)\ninstall(FILES ${B} DESTINATION share/robot)",
        "file(GLOB A /etc/*)\ninstall(FILES ${A} DESTINATION share/robot)",
        "file(GLOB A **x**)\nfile(GLOB B)\nfile(GLOB C ../*)",
        "install(PROGRAMS ${NOBODY_KNOWS} ${OR}/this.py DESTINATION lib/robot)",
        "\0\ufffd)(\"'",
    ],
)
def test_an_invalid_file_installs_nothing(folder: Path, text: str) -> None:
    found = read(folder, text)
    assert (found.programs, found.files) == ({}, {})


@pytest.mark.parametrize(
    "text",
    [
        "x" * 50000,
        "a(" * 20000,
        'a("' * 20000,
        "${" * 20000,
        "# " * 9999,
        "install(DIRECTORY " + '""' * 30000 + " DESTINATION x)",
        "install(FILES " + "data/x.yaml " * 20000 + " DESTINATION x RENAME y)",
    ],
)
def test_an_unusual_file_is_read_quickly(folder: Path, text: str) -> None:
    started = time.process_time()
    read(folder, text)
    assert time.process_time() - started < allowed(1)


def test_an_unknown_variable_can_be_extended_many_times(folder: Path) -> None:
    text = 'set(FLAGS "${FLAGS} -Wall")\n' * 50 + "install(FILES data/x.yaml DESTINATION share)"
    assert list(read(folder, text).files) == ["share/x.yaml"]


def test_names_of_variables_may_contain_variables(folder: Path) -> None:
    text = "set(A B)\nset(B_dir data)\ninstall(FILES ${${A}_dir}/x.yaml DESTINATION share)"
    assert list(read(folder, text).files) == ["share/x.yaml"]


def test_tests_are_found(folder: Path) -> None:
    found = read(
        folder,
        "add_launch_test(test/a.test.py TIMEOUT 20)\n"
        "ament_add_pytest_test(unit test/b.py WORKING_DIRECTORY x)\n"
        "ament_add_pytest_test(${name} ${path})\n"
        "ament_add_gtest(c test/c.cpp)\n",
    )
    assert found.tests == ["test/a.test.py", "test/b.py", "${path}"]


@pytest.mark.parametrize(
    ("text", "name", "place"),
    [
        ("ament_python_install_package(robot)", "robot", "robot"),
        (
            "ament_python_install_package(${PROJECT_NAME} PACKAGE_DIR python/core)",
            "robot",
            "python/core",
        ),
        ("ament_python_install_package(arm PACKAGE_DIR src VERSION 1)", "arm", "src"),
    ],
)
def test_python_packages_are_found(folder: Path, text: str, name: str, place: str) -> None:
    assert read(folder, text).python_packages == {name: folder / place}


def test_a_python_package_in_an_unknown_folder_is_left_out(folder: Path) -> None:
    assert read(folder, "ament_python_install_package(arm PACKAGE_DIR ${X})").python_packages == {}


def test_a_function_sees_the_variables_and_functions_of_its_caller(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(
        "set(A one)\nset(B two)\nfunction(g)\nadd_executable(${A}_${B} x)\nendfunction()\n"
        "function(f A)\nset(B three)\ng()\nfunction(h)\nendfunction()\nendfunction()\n"
        "f(four)\ng()\nh(five)\n"
    )
    assert list(read_cmake(tmp_path).compiled) == ["four_three", "one_two"]
