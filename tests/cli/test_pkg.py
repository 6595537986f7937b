"""Tests of `zbot pkg`: its lists, and packages that it creates and that run at once."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.cli.conftest import write_package
from zbot.package.manifest import read_manifest
from zbot.package.setup_file import declared_scripts, setup_arguments
from zbot_cli.packages import vscode
from zbot_cli.packages.creation import known_licenses

if TYPE_CHECKING:
    from tests.cli.conftest import Command

CREATED = """\
going to create a new package
package name: my_package
destination directory: {folder}
package format: 3
version: 0.0.0
description: TODO: Package description
maintainer: ['u <u@x.org>']
licenses: ['Apache-2.0']
build type: ament_python
dependencies: ['rclpy', 'std_msgs']
node_name: my_node
creating folder ./my_package
creating ./my_package/package.xml
creating source folder
creating folder ./my_package/my_package
creating ./my_package/setup.py
creating ./my_package/setup.cfg
creating folder ./my_package/resource
creating ./my_package/resource/my_package
creating ./my_package/my_package/__init__.py
creating folder ./my_package/test
creating ./my_package/test/test_copyright.py
creating ./my_package/test/test_flake8.py
creating ./my_package/test/test_pep257.py
creating ./my_package/my_package/my_node.py
"""
ME = ["--maintainer-name", "u", "--maintainer-email", "u@x.org"]


@pytest.fixture(autouse=True)
def known_author(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in list(os.environ):
        if name.startswith("GIT_"):
            monkeypatch.delenv(name)
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", str(tmp_path / "gitconfig"))
    monkeypatch.setenv("GIT_CONFIG_NOSYSTEM", "1")
    monkeypatch.setenv("LOGNAME", "Ana Maria")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


@pytest.fixture
def source(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the `src` folder of a workspace; it is the current folder."""
    monkeypatch.chdir(workspace)
    return workspace


# -- create --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "words",
    [
        ["my_package", "--dependencies", "rclpy", "std_msgs"],
        ["--dependencies", "rclpy", "std_msgs", "--build-type", "ament_python", "my_package"],
        ["--dependencies=rclpy", "my_package", "--dependencies", "std_msgs"],
    ],
)
def test_create_prints_each_step(source: Path, zbot_command: Command, words: list[str]) -> None:
    result = zbot_command(
        "pkg", "create", *words, "--node-name", "my_node", "--license", "Apache-2.0", *ME
    )
    assert result.out == CREATED.format(folder=source)
    assert (result.code, result.err) == (0, "")
    files = [path for path in (source / "my_package").rglob("*") if path.is_file()]
    assert {path.relative_to(source / "my_package").as_posix() for path in files} == {
        "LICENSE",
        "my_package/__init__.py",
        "my_package/my_node.py",
        "package.xml",
        "resource/my_package",
        "setup.cfg",
        "setup.py",
        "test/test_copyright.py",
        "test/test_flake8.py",
        "test/test_pep257.py",
    }


def test_a_created_package_has_the_given_facts(source: Path, zbot_command: Command) -> None:
    zbot_command(
        "pkg", "create", "a", "--dependencies", "rclpy", "--node-name", "n", "--description",
        'It\'s <5> & "more"', "--license", "\\ 'mine'", "--package-format", "2", *ME,
    )  # fmt: skip
    manifest = read_manifest(source / "a" / "package.xml")
    assert (manifest.name, manifest.build_type) == ("a", "ament_python")
    assert manifest.depends["depend"] == ("rclpy",)
    assert manifest.depends["test_depend"][0] == "ament_copyright"
    assert 'format="2"' in (source / "a" / "package.xml").read_text()
    arguments = setup_arguments(source / "a" / "setup.py")
    assert arguments["description"] == 'It\'s <5> & "more"'
    assert arguments["license"] == "\\ 'mine'"
    assert declared_scripts(source / "a") == {"n": "a.n:main"}
    assert zbot_command("pkg", "xml", "a", "-t", "description").out == 'It\'s <5> & "more"\n'


def test_a_created_package_runs_at_once(source: Path) -> None:
    zbot("pkg", "create", "my_package", "--node-name", "my_node", cwd=source)
    done = zbot("run", "my_package", "my_node", cwd=source)
    assert (done.code, done.out) == (0, "Hi from my_package.\n")
    assert zbot("run", "my_node", cwd=source / "my_package").out == "Hi from my_package.\n"


def test_a_created_package_has_files_for_vs_code(source: Path, zbot_command: Command) -> None:
    assert zbot_command("pkg", "create", "demo", "--node-name", "walk", "--vscode").code == 0
    folder = source / "demo" / ".vscode"
    read = {file.name: json.loads(file.read_text()) for file in folder.iterdir()}
    assert set(read) == {"extensions.json", "launch.json", "tasks.json"}
    walk, this_file = read["launch.json"]["configurations"]
    assert (walk["module"], walk["args"]) == ("zbot", ["run", "demo", "walk"])
    assert this_file["args"] == ["run", "${file}"]
    assert [task["args"][2] for task in read["tasks.json"]["tasks"]] == ["build", "test", "doctor"]


@pytest.mark.parametrize(
    ("line", "groups"),
    [
        ("src/a/setup.py:24: 'n' names mian()", ("src/a/setup.py", "24", None, "'n' names mian()")),
        ("a/package.xml: warning: too old", ("a/package.xml", None, "warning", "too old")),
        ("Summary: 0 packages finished", None),
        ("  1 package failed: demo", None),
    ],
)
def test_vs_code_finds_the_lines_of_errors(
    line: str, groups: tuple[str | None, ...] | None
) -> None:
    (build, *_) = json.loads(vscode.files("demo", "")["tasks.json"])["tasks"]
    match = re.match(build["problemMatcher"]["pattern"]["regexp"], line)
    assert (match and match.groups()) == groups


def test_linter_tests_of_a_created_package_are_skipped(source: Path, zbot_command: Command) -> None:
    zbot_command("pkg", "create", "my_package")
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "my_package"],
        capture_output=True,
        encoding="utf-8",
        check=False,
        cwd=source,
    )
    assert "3 skipped" in done.stdout, done.stdout


def test_the_maintainer_has_a_default(source: Path, zbot_command: Command, tmp_path: Path) -> None:
    assert (
        "maintainer: ['Ana Maria <ana.maria@todo.todo>']" in zbot_command("pkg", "create", "a").out
    )
    (tmp_path / "gitconfig").write_text("[user]\nname = Bo\nemail = bo@x.org\n")
    assert "maintainer: ['Bo <bo@x.org>']" in zbot_command("pkg", "create", "b").out
    assert (source / "b").is_dir()


@pytest.mark.parametrize("name", known_licenses())
def test_a_known_license_is_written(source: Path, zbot_command: Command, name: str) -> None:
    result = zbot_command("pkg", "create", "a", "--license", name, *ME)
    assert "WARNING" not in result.out
    text = (source / "a" / "LICENSE").read_text()
    assert len(text) > 500
    assert "$" not in text


def test_known_licenses_are_listed(zbot_command: Command) -> None:
    result = zbot_command("pkg", "create", "a", "--license", "?")
    assert result.code == 0
    assert result.out.splitlines()[:2] == ["Supported licenses:", "Apache-2.0"]


def test_an_unknown_license_causes_a_warning(source: Path, zbot_command: Command) -> None:
    result = zbot_command("pkg", "create", "a", "--license", "mine")
    assert result.code == 0
    assert (
        "\n[WARNING]: Unknown license 'mine'.  This has been set in the package.xml" in result.out
    )
    assert result.out.endswith("\nMIT-0\n")
    assert not (source / "a" / "LICENSE").exists()


def test_a_node_with_the_librarys_name_is_renamed(source: Path, zbot_command: Command) -> None:
    result = zbot_command("pkg", "create", "a", "--node-name", "x", "--library-name", "x")
    assert result.err == (
        "[WARNING] node name can not be equal to the library name\n"
        "[WARNING] renaming node to x_node\n"
    )
    assert (source / "a" / "a" / "x" / "__init__.py").is_file()
    assert declared_scripts(source / "a") == {"x_node": "a.x_node:main"}


@pytest.mark.parametrize("build_type", ["ament_cmake", "cmake"])
def test_a_cmake_package_is_created(source: Path, zbot_command: Command, build_type: str) -> None:
    result = zbot_command(
        "pkg", "create", "a", "--build-type", build_type, "--dependencies", "rclcpp",
        "--node-name", "n", "--library-name", "l", *ME,
    )  # fmt: skip
    assert result.code == 0
    assert "creating source and include folder\ncreating folder ./a/src\n" in result.out
    assert result.err == "\nhint: a C++ package needs ROS 2; zbot runs Python programs only\n"
    cmake = (source / "a" / "CMakeLists.txt").read_text()
    assert "find_package(rclcpp REQUIRED)" in cmake
    assert "add_executable(n src/n.cpp)" in cmake
    for name in ("src/n.cpp", "src/l.cpp", "include/a/l.hpp"):
        assert "$" not in (source / "a" / name).read_text()
    assert read_manifest(source / "a" / "package.xml").build_type == build_type
    assert zbot_command("pkg", "executables", "a").out == ""


def test_a_destination_folder_is_created(source: Path, zbot_command: Command) -> None:
    result = zbot_command("pkg", "create", "a", "--destination-directory", "deep/down")
    assert "creating folder deep/down/a\n" in result.out
    assert (source / "deep" / "down" / "a" / "setup.py").is_file()


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["taken"], 1, "\nAborted!\nThe directory already exists: ./taken\nEither remove the"),
        (["test"], 1, "Aborted since 'ament_python' packages can't be named 'test'. Please"),
        (["My-Robot!"], 1, "'My-Robot!' cannot be a package's name: use letters, digits and '_'"),
        (["My-Robot!"], 1, "hint: try 'my_robot'"),
        (["../up"], 1, "'../up' cannot be a package's name"),
        (["a", "--node-name", "node.py"], 1, "'node.py' cannot be a node's name"),
        (["a", "--node-name", "../n"], 1, "'../n' cannot be a node's name"),
        (["a", "--library-name", "l-l"], 1, "hint: try 'l_l'"),
        (
            ["a", "--destination-directory", "taken/file"],
            1,
            "unable to create folder: taken/file: ",
        ),
        (["--dependencies", "rclpy", "a"], 2, "name the new package"),
        (["a", "--build-type", "ament_cargo"], 2, "Invalid value for '--build-type'"),
        (["a", "--package-format", "4"], 2, "Invalid value for '--package-format'"),
        (["a", "b"], 2, "unexpected extra argument"),
    ],
)
def test_create_refuses_impossible_packages(
    source: Path, zbot_command: Command, words: list[str], code: int, text: str
) -> None:
    (source / "taken").mkdir()
    (source / "taken" / "file").touch()
    result = zbot_command("pkg", "create", *words)
    assert result.code == code
    assert not result.out or "going to create" in result.out
    assert text in result.err
    assert [entry.name for entry in source.iterdir()] == ["taken"]


@pytest.mark.skipif(sys.platform == "win32", reason="takes a POSIX folder of scripts")
def test_a_created_package_can_be_installed_by_pip(
    source: Path, zbot_command: Command, tmp_path: Path
) -> None:
    # An import of setuptools would replace distutils in this process.
    for name in ("setuptools", "wheel"):
        if importlib.util.find_spec(name) is None:
            pytest.skip(f"pip would have to fetch {name}")
    zbot_command("pkg", "create", "my_package", "--node-name", "my_node", *ME)
    done = subprocess.run(
        [
            sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "-q",
            "--no-index", "--disable-pip-version-check", "--prefix", str(tmp_path / "to"),
            "./my_package",
        ],
        capture_output=True,
        encoding="utf-8",
        check=False,
        cwd=source,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "to" / "share" / "my_package" / "package.xml").is_file()
    assert list((tmp_path / "to").rglob("my_node.py"))


# -- list, executables, prefix, xml --------------------------------------------------------------


def test_packages_are_listed(source: Path, zbot_command: Command) -> None:
    write_package(source, "my_robot")
    listed = zbot_command("pkg", "list").out.splitlines()
    assert listed == sorted(listed)
    assert {"my_robot", "std_msgs", "zbot_nodes"} <= set(listed)
    rows = json.loads(zbot_command("pkg", "list", "--json").out)
    wanted = {"name": "my_robot", "origin": "workspace", "folder": str(source / "my_robot")}
    assert wanted in rows


def test_executables_are_listed(source: Path, zbot_command: Command) -> None:
    folder = write_package(source, "my_robot", drive="my_robot.drive:main", arm="my_robot.arm:main")
    (folder / "my_robot" / "drive.py").touch()
    assert zbot_command("pkg", "executables", "my_robot").out == "my_robot arm\nmy_robot drive\n"
    assert "zbot_nodes talker\n" in zbot_command("pkg", "executables").out
    paths = zbot_command("pkg", "executables", "my_robot", "--full-path").out
    assert paths == f"my_robot.arm:main\n{folder / 'my_robot' / 'drive.py'}\n"
    rows = json.loads(zbot_command("pkg", "executables", "zbot_nodes", "--json").out)
    assert Path(rows[0]["file"]).name == f"{rows[0]['executable']}.py"


def test_a_package_without_executables_lists_none(zbot_command: Command) -> None:
    result = zbot_command("pkg", "executables", "std_msgs")
    assert (result.code, result.out) == (0, "")


def test_programs_that_cmake_installs_are_executables(source: Path, zbot_command: Command) -> None:
    folder = source / "arm"
    (folder / "nodes").mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>arm</name></package>")
    (folder / "CMakeLists.txt").write_text(
        "project(arm)\nset(NODES nodes/wave.py nodes/greet)\n"
        "install(PROGRAMS ${NODES} nodes/help.sh nodes/gone.py\n"
        "  DESTINATION lib/${PROJECT_NAME})\n"
    )
    (folder / "nodes" / "wave.py").write_text("print('waving')")
    (folder / "nodes" / "greet").write_text("#!/usr/bin/env python3\nprint('hello')")
    (folder / "nodes" / "help.sh").write_text("#!/bin/sh\n")
    assert zbot_command("pkg", "executables", "arm").out == "arm greet\narm wave.py\n"
    assert zbot("run", "arm", "wave.py", cwd=source).out == "waving\n"
    assert zbot("run", "arm", "greet", cwd=source).out == "hello\n"


def test_a_prefix_is_printed(source: Path, zbot_command: Command) -> None:
    folder = write_package(source, "my_robot")
    assert zbot_command("pkg", "prefix", "my_robot", "--share").out == f"{folder}\n"
    prefix = Path(zbot_command("pkg", "prefix", "my_robot").out.strip())
    assert (prefix / "share" / "my_robot" / "package.xml").is_file()


def test_a_manifest_is_printed(source: Path, zbot_command: Command) -> None:
    zbot_command("pkg", "create", "a", "--dependencies", "rclpy", "std_msgs")
    assert zbot_command("pkg", "xml", "a").out == (source / "a" / "package.xml").read_text()
    assert zbot_command("pkg", "xml", "a", "--tag", "depend").out == "rclpy\nstd_msgs\n"
    assert zbot_command("pkg", "xml", "a", "-t", "build_type").out == "ament_python\n"


def test_a_manifest_in_another_encoding_is_printed(source: Path, zbot_command: Command) -> None:
    folder = write_package(source, "my_robot")
    text = (
        "<?xml version='1.0' encoding='latin-1'?>\n<package><name>my_robot</name><a>ü</a></package>"
    )
    (folder / "package.xml").write_text(text, encoding="latin-1")
    assert "<a>ü</a>" in zbot_command("pkg", "xml", "my_robot").out
    assert zbot_command("pkg", "xml", "my_robot", "-t", "a").out == "ü\n"


@pytest.mark.parametrize("place", ["'lib/' + name", "os.path.join('lib', name)"])
def test_programs_among_data_files_are_executables(
    source: Path, zbot_command: Command, place: str
) -> None:
    folder = write_package(source, "my_robot")
    (folder / "nodes").mkdir()
    (folder / "nodes" / "wave.py").touch()
    (folder / "setup.py").write_text(
        "name = 'my_robot'\n"
        f"setup(data_files=[({place}, glob('nodes/*.py')), ('bin', ['setup.py'])])\n"
    )
    assert zbot_command("pkg", "executables", "my_robot").out == "my_robot wave.py\n"


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["executables", "nope"], "Package 'nope' not found\n"),
        (["prefix", "nope"], "Package not found\n"),
        (["prefix", "std_msg"], "Package not found\n\nhint: did you mean 'std_msgs'?\n"),
        (["prefix", "../x"], "'../x' is not a valid package name\n"),
        (["xml", "std_msg"], "Package not found\n\nhint: did you mean 'std_msgs'?\n"),
        (["xml", "nope"], "Package not found\n"),
        (["xml", "std_msgs"], "Package XML manifest not found\n"),
        (
            ["xml", "fine", "-t", "nope"],
            "XML tag not found\n\nhint: package.xml has the tags name, package\n",
        ),
        (["xml", "broken"], "package.xml:2: not valid XML: mismatched tag\n"),
        (
            ["xml", "bomb"],
            "package.xml: a package.xml must not define entities: remove <!ENTITY>\n",
        ),
        (["prefix", "torn"], "setup.py: line 1: "),
    ],
)
def test_mistakes_are_refused_with_a_sentence(
    source: Path, zbot_command: Command, words: list[str], text: str
) -> None:
    write_package(source, "fine")
    write_package(source, "broken")
    (source / "broken" / "package.xml").write_text("<package><name>broken</name>\n</x></package>")
    write_package(source, "bomb")
    (source / "bomb" / "package.xml").write_text(
        "<!DOCTYPE x [<!ENTITY a 'b'>]><package><name>bomb</name></package>"
    )
    write_package(source, "torn")
    (source / "torn" / "setup.py").write_text("setup(data_files=[(")
    result = zbot_command("pkg", *words)
    assert (result.code, result.out) == (1, "")
    assert text in result.err
