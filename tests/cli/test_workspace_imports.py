"""Tests of Python packages of the workspace that scripts, tests and launched programs import."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.command import zbot

LAUNCH = """
import sys
from alpha.tools import hello
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    command = "from alpha.tools import hello; print(hello(), sys.argv[1:])"
    plain = [sys.executable, "-c", "import sys; " + command, "plain"]
    script = ["python3", "src/beta/scripts/use.py", hello() + "s"]
    return LaunchDescription([
        ExecuteProcess(cmd=plain, output="screen", cwd="/"),
        ExecuteProcess(cmd=script, output="screen"),
    ])
"""


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Return a workspace with two packages. The programs of `beta` import `alpha`."""
    files = {
        "alpha/alpha/__init__.py": "",
        "alpha/alpha/tools.py": "def hello(): return 'hello'\n",
        "alpha/launch/other.launch.py": "",
        "beta/beta/__init__.py": "",
        "beta/scripts/use.py": "import sys\nfrom alpha.tools import hello\n"
        "print(hello(), sys.argv[1:])\n",
        "beta/launch/all.launch.py": LAUNCH,
        "beta/test/test_use.py": "from alpha.tools import hello\n"
        "def test_use():\n    assert hello() == 'hello'\n",
    }
    for name in ("alpha", "beta"):
        files[f"{name}/package.xml"] = f"<package><name>{name}</name></package>"
        files[f"{name}/setup.py"] = f"from setuptools import setup\nsetup(name='{name}')\n"
    for name, text in files.items():
        path = tmp_path / "ws" / "src" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tmp_path / "ws"


def test_a_script_imports_the_packages_of_its_workspace(workspace: Path, tmp_path: Path) -> None:
    script = workspace / "src" / "beta" / "scripts" / "use.py"
    for folder in (workspace, tmp_path):
        result = zbot("run", str(script), "5", cwd=folder)
        assert (result.code, result.out) == (0, "hello ['5']\n"), result.err


@pytest.mark.parametrize("given", ["", "jazzy"])
def test_programs_have_the_variables_of_a_sourced_ros(
    given: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if given:
        monkeypatch.setenv("ROS_DISTRO", given)
    text = "import os\nprint(os.environ['ROS_DISTRO'], os.environ['ROS_VERSION'])\n"
    (tmp_path / "show.py").write_text(text)
    assert zbot("run", "show.py", cwd=tmp_path).out == f"{given or 'kilted'} 2\n"
    (tmp_path / "show.launch.xml").write_text(
        '<launch><log message="I am $(env ROS_DISTRO)"/></launch>'
    )
    result = zbot("launch", "show.launch.xml", cwd=tmp_path)
    assert f"I am {given or 'kilted'}" in result.out + result.err


def test_launch_files_and_their_processes_import_the_packages(workspace: Path) -> None:
    result = zbot("launch", "src/beta/launch/all.launch.py", cwd=workspace)
    assert "hello ['plain']" in result.out
    assert "hello ['hellos']" in result.out


@pytest.mark.parametrize("folder", [".", "src", "src/beta"])
def test_tests_import_the_packages(workspace: Path, folder: str) -> None:
    path = Path("src/beta/test").relative_to(Path(folder).as_posix())
    result = zbot("test", str(path), cwd=workspace / folder)
    assert result.code == 0, result.out


def test_a_missing_module_of_a_launch_file_is_explained(workspace: Path) -> None:
    (workspace / "bad.launch.py").write_text("import alpha.tools, no_such_module\n")
    result = zbot("launch", "bad.launch.py", "-s", cwd=workspace)
    assert result.code == 1
    assert "bad.launch.py:1: ModuleNotFoundError: No module named 'no_such_module'" in result.err
    assert "hint: `zbot pkg deps` shows what is missing" in result.err


def test_tests_of_linters_are_skipped_and_others_run(workspace: Path) -> None:
    folder = workspace / "src" / "beta" / "test"
    for name in ("flake8", "pep257"):
        (folder / f"test_{name}.py").write_text(
            f"from ament_{name}.main import main\ndef test_{name}():\n    assert main() == 0\n"
        )
    result = zbot("test", "src/beta/test", cwd=workspace)
    assert result.code == 0
    assert "1 passed, 2 skipped" in result.out
    (folder / "test_use.py").unlink()
    result = zbot("test", "src/beta/test", cwd=workspace)
    assert (result.code, "2 skipped" in result.out) == (0, True)
    (folder / "test_other.py").write_text("import ament_other\n")
    assert "No module named 'ament_other'" in zbot("test", "src/beta/test", cwd=workspace).out


def test_a_package_that_cmake_installs_from_another_folder_is_imported(tmp_path: Path) -> None:
    for name, text in {
        "package.xml": "<package><name>arm</name></package>",
        "CMakeLists.txt": "project(arm)\n"
        "ament_python_install_package(arm_core PACKAGE_DIR python/core)\n"
        "install(PROGRAMS scripts/use DESTINATION lib/arm)\n",
        "python/core/__init__.py": "",
        "python/core/words.py": "WORD = 'hello'\n",
        "scripts/use": "#!/usr/bin/env python3\nfrom arm_core import words\nprint(words.WORD)\n",
    }.items():
        path = tmp_path / "src" / "arm" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    result = zbot("run", "arm", "use", cwd=tmp_path)
    assert (result.code, result.out) == (0, "hello\n"), result.err


def test_a_program_with_the_name_of_its_package_does_not_hide_it(tmp_path: Path) -> None:
    for name, text in {
        "package.xml": "<package><name>arm</name></package>",
        "CMakeLists.txt": "project(arm)\n"
        "ament_python_install_package(arm)\n"
        "install(PROGRAMS arm/arm.py DESTINATION lib/arm RENAME arm)\n",
        "arm/__init__.py": "",
        "arm/words.py": "WORD = 'hello'\n",
        "arm/arm.py": "from arm import words\nprint(words.WORD)\n",
    }.items():
        path = tmp_path / "src" / "arm" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    result = zbot("run", "arm", "arm", cwd=tmp_path)
    assert (result.code, result.out) == (0, "hello\n"), result.err


@pytest.mark.parametrize("name", ["tf2_ros", "rclpy", "sensor_msgs_py", "message_filters"])
def test_the_sources_of_a_package_of_zbot_are_not_imported(tmp_path: Path, name: str) -> None:
    source = tmp_path / "src" / f"{name}_py" / name
    source.mkdir(parents=True)
    (source / "__init__.py").write_text("raise ImportError('no C++ here')\n")
    (source.parent / "package.xml").write_text(f"<package><name>{name}_py</name></package>")
    (source.parent / "setup.py").write_text(f"setup(name='{name}_py')\n")
    (tmp_path / "use.py").write_text(f"import rclpy, {name}\nprint({name}.__file__)\n")
    for folder in (tmp_path, source.parent):
        result = zbot("run", str(tmp_path / "use.py"), cwd=folder)
        assert result.code == 0, result.err
        assert Path(result.out.strip()).parts[-4:-1] == ("compat", "packages", name)


@pytest.mark.parametrize("name", ["drive.test.py", "test_drive.part.py"])
def test_a_test_file_with_a_dot_in_its_name_runs(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("def test_it():\n    assert True\n")
    (tmp_path / "b.launch.py").write_text("raise RuntimeError('not a test')\n")
    (tmp_path / "a.py").write_text("def test_other():\n    assert True\n")
    result = zbot("test", name, "a.py", cwd=tmp_path)
    assert result.code == 0, result.out
    assert result.out.count("1 passed") == 2
