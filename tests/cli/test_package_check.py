"""Tests of the mistakes in packages that `zbot build` finds."""

from __future__ import annotations

import ast
import time
from typing import TYPE_CHECKING

import pytest

from tests.cli.conftest import MANIFEST
from tests.conftest import allowed
from zbot_cli.packages.check import check_package
from zbot_cli.packages.check.checked_package import imports

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.conftest import Command, Write

NOT_FOUND = "`ros2 launch` would not find it"
NOT_MADE = "ROS 2 would not generate code from it"
NO_PACKAGE = "ROS 2 would not find the package"
NO_PROGRAM = "`ros2 run` would not find the programs"
INDEX = "'share/ament_index/resource_index/packages'"
CFG = "[develop] script_dir=$base/lib/robot and [install] install_scripts=$base/lib/robot"
KNOWN = {"rclpy", "std_msgs", "geometry_msgs", "my_msgs"}


def problems(folder: Path) -> list[str]:
    start = f"src/{folder.name}/"
    return [str(problem).removeprefix(start) for problem in check_package(folder, KNOWN)]


# -- entry points ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("script", "text"),
    [
        (
            "'a = robot.drve:main'",
            "names the module robot.drve, which does not exist; did you mean 'rob",
        ),
        ("'a = nowhere.at:all'", "'a' names the module nowhere.at, which does not exist"),
        (
            "'a = robot.drive:mian'",
            "'a' names mian(), but drive.py has no mian(); did you mean 'main",
        ),
        ("'a = robot.drive:x'", "'a' names x(), but drive.py has no x()"),
        (
            "'a = robot.drive'",
            "'a = robot.drive' must have the form 'name = package.module:function'",
        ),
        ("'a robot.drive:main'", "'a robot.drive:main' must have the form"),
    ],
)
def test_an_entry_point_without_function_is_an_error(write: Write, script: str, text: str) -> None:
    folder = write(
        scripts=f"'fine = robot.drive:main',\n{script}", **{"robot/drive.py": "main = 1"}
    )
    (found,) = problems(folder)
    assert found.startswith("setup.py:14: ")
    assert text in found


@pytest.mark.parametrize(
    "source",
    [
        "def main(): ...",
        "async def main(): ...",
        "class main: ...",
        "from .other import main",
        "from .other import run as main",
        "from .other import *",
        "a, main = 1, 2",
        "main: int = 1",
        "try:\n    import x\nexcept ImportError:\n    def main(): ...",
        "if 1:\n    pass\nelse:\n    def main(): ...",
        "def main(:",  # reported once, as a syntax error
    ],
)
def test_an_entry_point_may_be_bound_by_any_statement(write: Write, source: str) -> None:
    folder = write(scripts="'a = robot.drive:main'", **{"robot/drive.py": source})
    assert not [line for line in problems(folder) if "names" in line]


def test_entry_points_of_a_layout_with_src(write: Write) -> None:
    folder = write(
        build_type="other",
        **{
            "pyproject.toml": '[project.scripts]\na = "robot.drive:main"\nb = "robot:run"\n',
            "src/robot/__init__.py": "",
            "src/robot/drive.py": "def main(): ...",
        },
    )
    assert problems(folder) == ["pyproject.toml:3: 'b' names run(), but __init__.py has no run()"]


# -- sources and manifests -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("source", "text"),
    [
        (b"x = 1\ndef f(:\n", "robot/bad.py:2: SyntaxError: invalid syntax"),
        (b"if 1:\nx = 1\n", "robot/bad.py:2: IndentationError: expected an indented block"),
        (b"x = '\xff'\n", "robot/bad.py:"),
        (b"x = 1\0\n", "robot/bad.py:"),
        (b"(" * 5000, "robot/bad.py:"),
        (b"x = " + b"-" * 100000 + b"1\n", "robot/bad.py:"),
    ],
)
def test_a_file_with_a_syntax_error_is_an_error(write: Write, source: bytes, text: str) -> None:
    folder = write()
    (folder / "robot" / "bad.py").write_bytes(source)
    (found,) = problems(folder)
    assert found.startswith(text)
    assert "\n" not in found


@pytest.mark.parametrize("name", ["docs/old.py", "templates/node.py", "tests/test_a.py"])
def test_a_syntax_error_in_a_file_that_is_not_installed_is_no_error(
    write: Write, name: str
) -> None:
    assert problems(write(**{name: "def {{ name }}("})) == []


@pytest.mark.parametrize(
    "name", ["robot/a.py", "robot/b/c.py", "scripts/a.py", "launch/a.launch.py"]
)
def test_a_syntax_error_in_an_installed_file_is_an_error(write: Write, name: str) -> None:
    (found,) = problems(write(**{name: "def f("}))
    assert found.startswith(f"{name}:1: SyntaxError: ")


def test_an_invalid_escape_is_not_an_error(write: Write) -> None:
    assert problems(write(**{"robot/fine.py": "x = '\\d'"})) == []


@pytest.mark.parametrize(
    ("manifest", "text"),
    [
        (
            "<package>\n<name>robot</name>\n</pakage>",
            "package.xml:3: not valid XML: mismatched tag",
        ),
        ("", "package.xml:1: not valid XML: no element found"),
        ("<pkg/>", "package.xml:1: the outermost tag is <pkg>, but must be <package>"),
        (
            "<package>\n  <name>robot</name>\n</package>",
            "package.xml:3: <version> is missing or em",
        ),
        (MANIFEST.replace("0.0.0", "1.0"), "package.xml:3: the version is '1.0', but must be thre"),
        (MANIFEST.replace("{name}", "a b"), "package.xml:2: 'a b' is not a valid package name"),
        (MANIFEST.replace("{name}", " "), "package.xml:2: <name> is missing or empty"),
        ("<!DOCTYPE x [<!ENTITY a 'b'>]><package/>", "package.xml: a package.xml must not define"),
    ],
)
def test_an_invalid_manifest_is_an_error(write: Write, manifest: str, text: str) -> None:
    folder = write()
    (folder / "package.xml").write_text(
        manifest.format(name="robot", more="", build_type="ament_python")
    )
    assert problems(folder)[0].startswith(text)


def test_a_setup_py_with_a_syntax_error_is_an_error(write: Write) -> None:
    folder = write(**{"setup.py": "from setuptools import setup\nsetup(entry_points={\n"})
    assert len(problems(folder)) == 1
    assert problems(folder)[0].startswith("setup.py:2: ")


@pytest.mark.parametrize(
    ("files", "text"),
    [
        ({"setup.py": b"\x00\xff" * 100}, "setup.py: "),
        ({"setup.py": b"setup(data_files=" + b"[] + " * 9999 + b"[])"}, "setup.py: "),
        ({"package.xml": b"\xff\xfe\x00"}, "package.xml:1: not valid XML: "),
        ({"package.xml": b"<package>" * 9999}, "package.xml:1: its tags are nested deeper"),
        ({"msg/A.msg": b"int32 \xff\n"}, "msg/A.msg: cannot be read: "),
        ({"srv/A.srv": b"int32 a\n"}, "srv/A.srv: "),
        ({"robot/a.py": b"\xff"}, "robot/a.py"),
        ({"CMakeLists.txt": b"install(FILES \xff DESTINATION x)"}, "CMakeLists.txt:1: install() "),
    ],
)
def test_malicious_files_are_errors(write: Write, files: dict[str, bytes], text: str) -> None:
    folder = write()
    for name, content in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content)
    assert problems(folder)[0].startswith(text)


def test_files_in_other_encodings(write: Write) -> None:
    folder = write()
    setup = "# -*- coding: latin-1 -*-\n# ü\nfrom setuptools import setup\nsetup(name='robot')\n"
    (folder / "setup.py").write_text(setup, encoding="latin-1")
    assert not [problem for problem in problems(folder) if "warning" not in problem]


def test_a_folder_in_the_place_of_a_file_is_an_error(write: Write, zbot_command: Command) -> None:
    folder = write()
    (folder / "setup.py").unlink()
    (folder / "setup.py").mkdir()
    (folder / "launch").symlink_to(folder)
    result = zbot_command("build")
    assert result.code == 1
    assert "src/robot/setup.py: " in result.err


def test_a_compiled_program_is_a_warning(write: Write, zbot_command: Command) -> None:
    folder = write(build_type="ament_cmake", **{"CMakeLists.txt": "add_executable(drive a.cpp)\n"})
    problem = "drive is not compiled: C++ needs ROS 2, zbot runs Python programs"
    assert problems(folder) == [f"CMakeLists.txt:1: warning: {problem}"]
    assert "drive of package robot does not run here: it is a C++ program" in (
        zbot_command("run", "robot", "drive").err
    )


def test_a_python_package_that_zbot_has_itself_is_a_warning(write: Write) -> None:
    folder = write(**{"tf2_ros/__init__.py": "", "other/__init__.py": ""})
    assert "tf2_ros/__init__.py: warning: programs import zbot's own tf2_ros and not this one" in (
        problems(folder)
    )


def test_undeclared_imports_are_warnings(write: Write) -> None:
    folder = write(
        more="<exec_depend>rclpy</exec_depend>\n",
        **{
            "robot/a.py": "import os, numpy\nimport rclpy\nfrom std_msgs.msg import String\n",
            "robot/b.py": "from std_msgs.msg import Int32\nfrom . import my_msgs\n",
            "robot/c.py": "def f():\n    import geometry_msgs.msg as g\n",
            "robot/d.py": "try:\n    import my_msgs\nexcept ImportError:\n    my_msgs = None\n",
            "robot/e.py": "import robot.a\n",
        },
    )
    text = "warning: imports {0}: add <depend>{0}</depend> to package.xml"
    assert problems(folder) == [
        f"robot/a.py:3: {text.format('std_msgs')}",
        f"robot/c.py:2: {text.format('geometry_msgs')}",
    ]


# -- what is installed -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (
            "('share/x', ['resource/robt'])",
            "setup.py:10: data_files names resource/robt, which does ",
        ),
        (
            "('share/x', ['a/' + name])",
            "setup.py:3: data_files names a/robot, which does not exist",
        ),
    ],
)
def test_missing_data_files_are_errors(write: Write, data: str, text: str) -> None:
    (found,) = problems(write(data=data))
    assert found.startswith(text)


def test_a_missing_package_folder_is_an_error(write: Write) -> None:
    folder = write()
    (folder / "robot" / "__init__.py").unlink()
    (folder / "robot").rmdir()
    assert problems(folder) == ["setup.py:3: `packages` names robot, but there is no such folder"]


def test_different_names_in_setup_py_and_manifest_are_an_error(write: Write) -> None:
    folder = write(
        **{"package.xml": MANIFEST.format(name="rob", more="", build_type="ament_python")}
    )
    assert problems(folder) == ["setup.py:3: the package is 'robot' here, but 'rob' in package.xml"]


@pytest.mark.parametrize(
    ("build_type", "file"), [("ament_python", "setup.py"), ("ament_cmake", "CMakeLists.txt")]
)
def test_a_build_type_without_file_is_an_error(write: Write, build_type: str, file: str) -> None:
    folder = write(build_type=build_type)
    (folder / file).unlink(missing_ok=True)
    assert problems(folder) == [
        f"package.xml:7: the build type is {build_type}, but there is no {file}"
    ]


def test_files_that_ros_2_would_not_find_are_warnings(write: Write) -> None:
    folder = write(**{"launch/a.launch.py": "", "launch/notes.txt": ""})
    (folder / "setup.py").write_text("from setuptools import setup\nsetup(name='robot')\n")
    (folder / "setup.cfg").unlink()
    assert problems(folder) == [
        f"launch/a.launch.py: warning: setup.py does not install it: {NOT_FOUND}",
        f"setup.py: warning: data_files lacks ({INDEX}, ['resource/robot']): {NO_PACKAGE}",
        f"setup.py: warning: data_files lacks ('share/robot', ['package.xml']): {NO_PACKAGE}",
        f"setup.py: warning: there is no setup.cfg: {NO_PROGRAM}; write {CFG}",
    ]


@pytest.mark.parametrize(
    ("file", "old", "new", "problem"),
    [
        (
            "setup.py",
            "'a = robot.a:main',",
            "'a = robot.a:main'",
            "py:13: a comma is missing",
        ),
        (
            "setup.py",
            ":main',\n        'b",
            ":main()',\n        'b",
            "write main, without",
        ),
        ("setup.py", "'b = ", "'a = ", "setup.py:14: 'a' is declared twice"),
        ("setup.py", "'console_scripts'", "'console_script'", "did you mean 'console_scripts'?"),
        ("setup.py", "entry_points=", "entry_point=", "setup() has no argument 'entry_point'; did"),
        ("setup.py", "data_files=", "data_file=", "setup() has no argument 'data_file'; did you"),
        (
            "setup.py",
            "packages=[name]",
            "packages=['robt']",
            "did you mean 'robot'?",
        ),
        (
            "setup.py",
            "name = 'robot'",
            "name = 'robt'",
            "is 'robt' here, but 'robot' in",
        ),
        (
            "setup.py",
            "['package.xml']),",
            "['package.xml' 'setup.py']),",
            "a comma is missing between 'package.xml' and 'setup.py'",
        ),
        ("setup.py", "['package.xml']),", "['package.xml'])", "perhaps you missed a comma?"),
        ("setup.py", "('share/' + name, ['package.xml']),", "", "lacks ('share/robot', ['package"),
        (
            "setup.cfg",
            "script_dir",
            "script-dir",
            "cfg:2: warning: write script_dir, not",
        ),
        (
            "setup.cfg",
            "install_scripts",
            "install-scripts",
            "cfg:4: warning: write install_s",
        ),
        (
            "setup.cfg",
            "lib/robot\n[",
            "lib/robt\n[",
            "write script_dir=$base/lib/robot: ",
        ),
        ("setup.cfg", "[install]\n", "", "add install_scripts=$base/lib/robot below [install]"),
        ("setup.cfg", "[develop]\n", "", "setup.cfg:1: File contains no section headers."),
        ("package.xml", "ament_python", "ament_pyton", "there is no build type 'ament_pyton'; did"),
    ],
)
def test_a_mistake_in_the_setup_files_is_named(
    write: Write, file: str, old: str, new: str, problem: str
) -> None:
    programs = {f"robot/{name}.py": "def main(): pass\n" for name in "ab"}
    folder = write(scripts="'a = robot.a:main',\n        'b = robot.b:main',", **programs)
    assert problems(folder) == []
    text = (folder / file).read_text()
    assert old in text
    (folder / file).write_text(text.replace(old, new, 1))
    assert problem in "\n".join(problems(folder))


@pytest.mark.parametrize(
    ("name", "advice"),
    [
        ("other.py", "robot: warning: add an empty __init__.py"),
        ("_init_.py", "robot/_init_.py: warning: rename _init_.py to __init__.py"),
    ],
)
def test_a_folder_of_modules_without_init_is_a_warning(
    write: Write, name: str, advice: str
) -> None:
    folder = write()
    (folder / "robot" / "__init__.py").rename(folder / "robot" / name)
    assert problems(folder) == [
        f"{advice}: without it, ROS 2 would not install the modules of this folder"
    ]


def test_a_configuration_that_is_not_installed_is_a_warning(write: Write) -> None:
    assert problems(write(**{"config/a.yaml": ""})) == [
        "config/a.yaml: warning: setup.py does not install it: programs would not find it in ROS 2"
    ]


def test_pkg_check_names_the_problems(write: Write, zbot_command: Command) -> None:
    write("good")
    write("bad", scripts="'a = bad.gone:main'")
    assert zbot_command("pkg", "check", "good").code == 0
    checked = zbot_command("pkg", "check")
    assert (checked.code, checked.out) == (1, "")
    assert "src/bad/setup.py:13: 'a' names the module bad.gone" in checked.err
    assert "did you mean 'good'?" in zbot_command("pkg", "check", "god").err


def test_files_installed_by_cmake_are_checked(write: Write) -> None:
    cmake = """\
project(robot)
install(PROGRAMS scripts/a.py scripts/gone.py
  DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch nowhere DESTINATION share/${PROJECT_NAME})
install(PROGRAMS ${UNKNOWN}/x.py $<TARGET_FILE:x> DESTINATION lib/${PROJECT_NAME})
"""
    files = {"CMakeLists.txt": cmake, "scripts/a.py": "x = (", "launch/a.launch.py": ""}
    assert problems(write(build_type="ament_cmake", **files)) == [
        "CMakeLists.txt:2: install() names scripts/gone.py, which does not exist",
        "CMakeLists.txt:4: install() names nowhere, which does not exist",
        "scripts/a.py:1: SyntaxError: '(' was never closed",
    ]


# -- interfaces ------------------------------------------------------------------------------------


GENERATE = """\
project(my_msgs)
rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/A.msg"
  "srv/Gone.srv"
  DEPENDENCIES std_msgs
)
"""
PARTS = "goal, result and feedback of an action"
ADD = "add <depend>geometry_msgs</depend> to package.xml"
GROUP = "<member_of_group>rosidl_interface_packages</member_of_group>\n"


def test_definitions_are_parsed(write: Write) -> None:
    folder = write(
        "my_msgs",
        build_type="ament_cmake",
        more=f"<depend>std_msgs</depend>{GROUP}",
        **{
            "CMakeLists.txt": GENERATE,
            "msg/A.msg": "# fine\nint32 a\nflot64 x\n",
            "msg/B.msg": "std_msgs/Strng s\ngeometry_msgs/Point p\nC c\nD d\n",
            "msg/C.msg": "std_msgs/Header header\n",
            "action/Go.action": "int32 a\n---\n",
        },
    )
    assert problems(folder) == [
        "CMakeLists.txt:2: rosidl_generate_interfaces names srv/Gone.srv, which does not exist",
        f"action/Go.action: 2 lines '---' are needed between {PARTS}, but there is one",
        "msg/A.msg:3: there is no type 'flot64'; did you mean 'float64'?",
        "msg/B.msg:1: there is no type std_msgs/msg/Strng; did you mean 'std_msgs/msg/String'?",
        "msg/B.msg:4: there is no type my_msgs/msg/D; did you mean 'my_msgs/msg/A'?",
        f"CMakeLists.txt: warning: rosidl_generate_interfaces lacks action/Go.action: {NOT_MADE}",
        f"CMakeLists.txt: warning: rosidl_generate_interfaces lacks msg/B.msg: {NOT_MADE}",
        f"CMakeLists.txt: warning: rosidl_generate_interfaces lacks msg/C.msg: {NOT_MADE}",
        f"msg/B.msg:2: warning: geometry_msgs/msg/Point is used: {ADD}",
    ]


def test_a_message_package_must_be_in_the_group_of_interfaces(write: Write) -> None:
    cmake = GENERATE.replace('  "srv/Gone.srv"\n', "")
    folder = write(
        "my_msgs", build_type="ament_cmake", **{"CMakeLists.txt": cmake, "msg/A.msg": "int32 a"}
    )
    assert problems(folder) == [f"package.xml: add {GROUP.strip()} for the messages"]


def test_messages_in_a_python_package_are_a_warning(write: Write) -> None:
    (found,) = problems(write(**{"msg/A.msg": "int32 a"}))
    assert found.startswith("package.xml: warning: ROS 2 makes messages in ament_cmake packages")


def test_imports_in_many_levels_of_try_are_found_quickly() -> None:
    depths = range(95)
    source = [" " * depth + "try:\n" for depth in depths]
    source += [" " * 95 + "import b; a = 1; a; a; a; a; a; a\n"] * 2000
    source += [" " * depth + "except E: import c\n" for depth in reversed(depths)]
    tree = ast.parse("".join([*source, "import d\n"]))
    begin = time.process_time()
    assert sorted(name for name, _, _ in imports(tree)) == ["c", "d"]
    assert time.process_time() - begin < allowed(1)
