"""Programs that import ROS 2's names without `import zbot`, as Python runs them at its start."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import zbot_ros2_names
from zbot.compat import _PACKAGES
from zbot.interfaces.location import shipped_packages

ROOT = Path(__file__).parents[2]
PTH = ROOT / "zbot_ros2_names.pth"


def python(source: str, *options: str, path: str = "") -> subprocess.CompletedProcess[str]:
    """Run a program after the line of the .pth file, as the module `site` executes it."""
    entries = [path, str(ROOT), os.environ["PYTHONPATH"]]
    return subprocess.run(
        [sys.executable, "-S", *options, "-c", f"{_site_packages()}\n{PTH.read_text()}\n{source}"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, entries))},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


def _site_packages() -> str:
    folders = [entry for entry in sys.path if entry.endswith(("site-packages", "dist-packages"))]
    return f"import sys; sys.path += {folders!r}"


@pytest.mark.parametrize(
    "line",
    [
        "import rclpy; rclpy.init(args=[]); rclpy.shutdown()",
        "from rclpy.node import Node",
        "from std_msgs.msg import String; String(data='hi')",
        "from std_srvs.srv import SetBool",
        "from turtlesim.msg import Pose",
        "from launch_ros.actions import Node",
        "import zbot, rclpy, std_msgs.msg",
    ],
)
def test_a_program_needs_no_import_of_zbot(line: str) -> None:
    result = python(line)
    assert (result.returncode, result.stderr) == (0, "")


def test_every_name_that_zbot_has_is_found() -> None:
    own = {folder.name for folder in Path(_PACKAGES).iterdir() if folder.name[0] not in "_."}
    names = {*own, *shipped_packages()}
    assert all(zbot_ros2_names.is_known(name) for name in names)
    assert names >= zbot_ros2_names.NAMES


def test_a_package_of_ros_1_is_told_as_such() -> None:
    assert "which is of ROS 1: write import rclpy\n" in python("import rospy").stderr
    assert python("import importlib.util as u; print(u.find_spec('rospy'))").stdout == "None\n"


def test_a_real_package_is_used_instead(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ZBOT_RCLPY", raising=False)
    (tmp_path / "rclpy.py").write_text("whose = 'real'\n")
    result = python("import rclpy; print(rclpy.whose)", path=str(tmp_path))
    assert result.stdout == "real\n"


@pytest.fixture
def other_ros2(tmp_path: Path) -> str:
    """Return a folder with packages that look like those of a genuine ROS 2."""
    (tmp_path / "rclpy.py").write_text("whose = 'real'\n")
    for package in ("std_msgs", "hand_written"):
        (tmp_path / package / "msg").mkdir(parents=True)
        (tmp_path / package / "__init__.py").touch()
        (tmp_path / package / "msg" / "__init__.py").write_text("class String: whose = 'real'\n")
        (tmp_path / package / "msg" / "String.msg").write_text("string data\n")
    (tmp_path / "std_msgs" / "std_msgs_s__rosidl_typesupport_c.so").touch()
    return str(tmp_path)


def test_zbots_packages_win_if_they_are_preferred(
    other_ros2: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = "from std_msgs.msg import String; import rclpy.node; print(rclpy.node, String())"
    monkeypatch.delenv("ZBOT_RCLPY", raising=False)
    assert "'rclpy' is not a package" in python(source, path=other_ros2).stderr
    monkeypatch.setenv("ZBOT_RCLPY", "zbot")
    result = python(source, path=other_ros2)
    assert result.stderr == ""
    assert "std_msgs.msg.String(data='')" in result.stdout


def test_a_module_that_a_person_wrote_wins_always(
    other_ros2: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_RCLPY", "zbot")
    source = "import zbot; from hand_written.msg import String; print(String.whose)"
    assert python(source, path=other_ros2).stdout == "real\n"


def test_a_folder_of_the_same_name_is_not_taken_for_a_package(tmp_path: Path) -> None:
    (tmp_path / "launch").mkdir()
    (tmp_path / "std_msgs" / "msg").mkdir(parents=True)
    source = "from launch import LaunchDescription; from std_msgs.msg import String"
    result = python(source, path=str(tmp_path))
    assert (result.returncode, result.stderr) == (0, "")


def test_other_programs_load_nothing_of_zbot() -> None:
    source = (
        "import json, importlib\n"
        "try: import no_such_module\n"
        "except ImportError: pass\n"
        "importlib.invalidate_caches()\n"
        "print(sorted(name for name in sys.modules if 'zbot' in name))"
    )
    result = python(source)
    assert (result.stdout, result.stderr) == ("['zbot_ros2_names']\n", "")


def test_an_unknown_package_of_messages_is_not_found() -> None:
    result = python("import no_such_msgs")
    last = result.stderr.splitlines()[-1]
    assert "No module named 'no_such_msgs'" in last
    assert "no_such_msgs/msg" in last


def test_the_line_is_silent_where_zbot_is_gone() -> None:
    result = subprocess.run(
        [sys.executable, "-I", "-S", "-c", PTH.read_text()],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (result.returncode, result.stderr) == (0, "")


def test_a_package_of_the_workspace_is_imported_before_rclpy(tmp_path: Path) -> None:
    folder = tmp_path / "src" / "my_interfaces"
    (folder / "msg").mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>my_interfaces</name></package>")
    (folder / "msg" / "Num.msg").write_text("int64 num\n")
    source = "from my_interfaces.msg import Num; print(Num(num=1))"
    assert (
        python(f"import os; os.chdir({str(tmp_path)!r}); {source}").stdout
        == "my_interfaces.msg.Num(num=1)\n"
    )


def test_a_python_package_of_a_sourced_workspace_is_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("tools", "launch"):
        (tmp_path / "src" / "alpha" / name).mkdir(parents=True)
    (tmp_path / "src" / "alpha" / "package.xml").write_text("<package><name>alpha</name></package>")
    (tmp_path / "src" / "alpha" / "tools" / "__init__.py").write_text("word = 'hello'\n")
    (tmp_path / "src" / "alpha" / "setup.py").touch()
    source = "import tools, launch; from launch.actions import GroupAction; print(tools.word)"
    assert "No module named 'tools'" in python(source).stderr
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path / "src"))
    result = python(source)
    assert (result.stdout, result.stderr) == ("hello\n", "")
    assert "No module named 'setup'" in python("import setup").stderr
    # Python looks for `sitecustomize` at each start, and on Debian for `apport_python_hook`.
    for name in ("sitecustomize", "apport_python_hook"):
        source = f"try: import {name}\nexcept ImportError: pass"
        assert python(f"{source}\nimport sys; print('zbot' in sys.modules)").stdout == "False\n"


def test_editors_find_the_types_on_the_path() -> None:
    result = python("print(*sys.path[-2:], sep='\\n')")
    stubs, packages = result.stdout.splitlines()
    assert (Path(stubs) / "std_msgs" / "msg" / "__init__.pyi").is_file()
    assert (Path(packages) / "rclpy" / "node.py").is_file()


def test_types_of_another_copy_on_the_path_are_no_modules(tmp_path: Path) -> None:
    # pytest-xdist gives its workers the path of the process that started them.
    stubs = tmp_path / "zbot" / "compat" / "stubs"
    (stubs / "nav2_msgs").mkdir(parents=True)
    source = (
        f"sys.path_importer_cache.clear(); sys.path.append('{stubs}/')\n"
        "import nav2_msgs; print(nav2_msgs.__doc__)"
    )
    assert "made by zbot" in python(source).stdout


def test_the_start_of_an_interpreter_takes_less_than_two_milliseconds_longer() -> None:
    runs = (python("pass", "-X", "importtime").stderr.splitlines() for _ in range(5))
    lines = (line for run in runs for line in run if line.endswith("| zbot_ros2_names"))
    assert min(int(line.split("|")[1]) for line in lines) < 2000  # microseconds
