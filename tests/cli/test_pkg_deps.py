"""Tests of `zbot pkg deps`, which shows what a workspace uses and what is not here."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from zbot.errors.installation import pip_install
from zbot.package.unavailable import unavailable_package
from zbot_cli.packages.python_sources import how_to_get, module_of_key

if TYPE_CHECKING:
    from tests.cli.conftest import Command, Write

NODE = """\
import json, os.path, no_such_library
import robot.words, helper, robot_tools
from rclpy.node import Node
from px4_msgs.msg import VehicleStatus
from no_such_interfaces.srv import Open
from std_msgs.msg import String, Strng
from control_msgs.msg import PidState, PidSatte
from arm.tools import hello
from moveit_configs_utils import MoveItConfigsBuilder
import ament_flake8
from winches.parameters import winch_parameters
try:
    import optional_thing
except ImportError:
    pass
"""
MORE = """\
  <depend>python3-no-such-library</depend>
  <exec_depend>python3-pip</exec_depend>
  <exec_depend>python3-no-such-thing-pip</exec_depend>
  <exec_depend>xacro</exec_depend>
  <exec_depend>cartographer_ros</exec_depend>
  <exec_depend>some_driver</exec_depend>
  <exec_depend>arm</exec_depend>
  <exec_depend condition="$ROS_VERSION == 1">roscpp</exec_depend>
  <depend>ublox_msgs</depend>
  <test_depend>ament_copyright</test_depend>
"""


def test_what_a_workspace_lacks_is_listed(write: Write, zbot_command: Command) -> None:
    write(
        more=MORE,
        **{"robot/drive.py": NODE, "robot/helper.py": "", "robot/words.py": ""},
        **{"more/robot_tools.py": ""},
        **{"msg/A.msg": "int32 a\nant_msgs/Leaf leaf\ngeometry_msgs/Pose pose\nB b\n"},
        **{"msg/B.msg": "int32 a\n"},
    )
    write("arm", **{"arm/tools.py": ""})
    write("winches", build_type="ament_cmake", **{"CMakeLists.txt": "project(winches)\n"})
    result = zbot_command("pkg", "deps")
    lines = [line.strip() for line in result.out.splitlines()]
    assert result.code == 1
    for first, second in (
        ("px4_msgs  (src/robot/robot/drive.py:4)", "download https://github.com/PX4/px4_msgs and"),
        ("ublox_msgs  (src/robot/package.xml:15)", "download https://github.com/KumarRobotics"),
        ("no_such_interfaces  (src/robot/robot/drive.py:5)", "type `zbot interface add` with the"),
        ("ant_msgs  (src/robot/msg/A.msg:2)", "type `zbot interface add` with the folder or"),
        ("std_msgs/msg/Strng  (src/robot/robot/drive.py:6)", "the version of std_msgs that is her"),
        ("control_msgs/msg/PidSatte  (src/robot/robot/drive.py:7)", "the version of control_msgs"),
        ("no_such_library  (src/robot/robot/drive.py:1)", pip_install("no_such_library")),
        (
            "moveit_configs_utils  (src/robot/robot/drive.py:9)",
            "download https://github.com/moveit",
        ),
        ("winches  (src/robot/robot/drive.py:11)", "the package is here, but only a build with"),
        ("no_such_thing  (src/robot/package.xml:9)", pip_install("no_such_thing")),
    ):
        assert lines[lines.index(first) + 1].startswith(second)
    assert lines[-3:-1] == [
        "Other packages that package.xml names and that are not here:",
        "some_driver",
    ]
    assert lines[-1].startswith("cartographer_ros: a navigation program in C++; `zbot launch nav2_")
    for word in ("optional_thing", "helper", "robot_tools", "roscpp", "rclpy", "ament_", "python3"):
        assert word not in result.out
    rows = json.loads(zbot_command("pkg", "deps", "robot", "--json").out)
    assert {row["kind"] for row in rows} == {"message", "python", "other"}
    assert {"winches", "arm"} & {row["name"] for row in rows} == {"winches"}
    assert set(rows[0]) == {"name", "kind", "file", "line", "get"}


def test_a_complete_workspace_lacks_nothing(write: Write, zbot_command: Command) -> None:
    write(**{"robot/drive.py": "import rclpy, tf2_ros\nfrom std_msgs.msg import String\n"})
    result = zbot_command("pkg", "deps")
    assert (result.code, result.err) == (0, "")
    assert result.out == "No message or Python package is missing in 1 package.\n"
    result = zbot_command("pkg", "deps", "robt")
    assert result.code == 1
    assert "Package 'robt' not found" in result.err


@pytest.mark.parametrize(
    ("key", "module", "how"),
    [
        ("python3-serial", "serial", pip_install("pyserial")),
        ("python3-opencv", "cv2", pip_install("opencv-python")),
        ("python3-yaml", "yaml", pip_install("pyyaml")),
        ("python3-ultralytics-pip", "ultralytics", pip_install("ultralytics")),
        ("python3-pyqt5", "PyQt5", pip_install("pyqt5")),
        ("xacro", "xacro", pip_install("xacro")),
        ("python3-tk", "tkinter", "install your system's package python3-tk"),
        ("python3-rospy", "rospy", "rospy is a part of ROS 1: use its successor in ROS 2"),
    ],
)
def test_keys_of_rosdep_mean_modules(key: str, module: str, how: str) -> None:
    assert module_of_key(key) == module
    assert how_to_get(module) == how
    assert module_of_key("rviz2") == ""


@pytest.mark.parametrize(
    "module", ["moveit_configs_utils", "launch_param_builder", "srdfdom", "urdf_parser_py"]
)
def test_a_launch_names_the_repositories_of_moveit_too(module: str) -> None:
    kind = unavailable_package(module)
    repository = how_to_get(module).removeprefix("download https://github.com/").split()[0]
    assert kind is not None
    assert repository.removesuffix("/tree/ros2") in kind.instead
    assert repository.endswith("/tree/ros2") is (module in {"srdfdom", "urdf_parser_py"})
