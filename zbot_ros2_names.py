"""Finder of ROS 2's names, which makes `import rclpy` work in every program without `import zbot`.

Python imports this module when it starts, because `zbot_ros2_names.pth` is installed with zbot.
The module must be small and must import nothing: it also runs before programs that do not use zbot.

The finder is the first on `sys.meta_path`, because Python's own finder accepts any folder named
`launch`, and most packages have such a folder. If a real ROS 2 is installed, its packages are used,
except in programs of `zbot run`, `zbot launch` and `zbot test`, which set ZBOT_RCLPY.
At the first import of a ROS 2 name that is not installed, the finder loads `zbot.compat`, which has
finders of its own, and removes itself. If ZBOT_WORKSPACE is set, as after `source
install/setup.bash`, any name that Python does not find may be a package of the workspace.

Editors take the folders to search from `sys.path`. So two folders with types are added to
`sys.path`: the stubs of message classes, and zbot's packages such as `rclpy`. Python itself does
not search these folders.

PYTEST_DONT_REWRITE tells pytest not to warn that it cannot rewrite the assertions of this module.
"""

import sys

#: ROS 2's packages of which zbot has Python code or message types. A test checks this list.
NAMES = frozenset({
    "action_tutorials_interfaces", "actionlib_msgs", "ament_index_python", "bond",
    "camera_info_manager", "controller_manager", "cv_bridge", "diagnostic_updater",
    "domain_coordinator",
    "image_geometry", "interactive_markers", "laser_geometry", "launch", "launch_pytest",
    "launch_ros", "launch_testing", "launch_testing_ros", "launch_xml", "launch_yaml",
    "message_filters", "nav2_common", "nav2_simple_commander", "rclpy", "robot_localization",
    "ros_gz_bridge", "ros_gz_sim",
    "ros2action", "ros2cli", "ros2launch", "ros2node", "ros2param", "ros2pkg", "ros2service",
    "ros2topic", "rosbag2_py",
    "rosidl_adapter", "rosidl_parser", "rosidl_pycommon", "rosidl_runtime_py", "sensor_msgs_py",
    "slam_toolbox", "std_srvs", "tf2_geometry_msgs", "tf2_py", "tf2_ros", "tf2_sensor_msgs",
    "tf_transformations", "turtlesim",
})  # fmt: skip
#: Packages of ROS 1. The error for one of these says what to import in its place.
_OF_ROS_1 = frozenset({"actionlib", "dynamic_reconfigure", "roslib", "rospkg", "rospy", "tf"})
#: Ends of the names of packages with messages, also of students' own packages, and of wrong names.
_SUFFIXES = ("_msgs", "_interfaces", "_srvs", "_msg", "_interface", "_srv")
#: Modules that Python looks for at each start, the last one on Debian and Ubuntu. Few machines have
#: them.
_OF_SITE = ("sitecustomize", "usercustomize", "apport_python_hook")
#: This finder imports it while Python searches for zbot.
_OF_FINDER = "zbot_name_clash"
#: The last slash makes these paths different from the path that `zbot.compat` searches.
_TYPES = ("/zbot/compat/stubs/", "/zbot/compat/packages/")


class _Finder:
    """Finder that loads zbot when a program imports a name of ROS 2 that is not installed.

    At the first import of zbot or of such a name, it checks the names of the program's files.
    """

    watches_files = False

    @staticmethod
    def find_spec(fullname, path=None, target=None):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN205 - `typing` would be imported
        """Return the spec that zbot's own finders have for a top-level package."""
        is_ours = is_known(fullname) or fullname == "zbot"
        if path is not None or not (is_ours or _is_sourced(fullname)):
            return None
        if is_ours and not _Finder.watches_files:
            _Finder.watches_files = True
            import zbot_name_clash  # noqa: PLC0415 - only for programs that use zbot

            zbot_name_clash.watch(sys.path[:1])
        if fullname == "zbot":
            return _other_spec(fullname, target)  # type: ignore[no-untyped-call]
        installed = _other_spec(fullname, target)  # type: ignore[no-untyped-call]
        if installed is not None and installed.origin is not None and not _prefers_zbot():
            return installed
        import zbot.compat  # noqa: F401, PLC0415 - only for programs that use ROS 2's names
        from zbot.process import error_advice  # noqa: PLC0415 - as above

        error_advice.install()  # before `init()`: a class statement may be wrong
        remove()  # zbot's finders are asked now, and may themselves ask all finders
        return _spec_of_zbot(fullname, target)  # type: ignore[no-untyped-call]


class _Nothing:
    """Finder for a folder with types on `sys.path`. It finds no module in the folder."""

    @staticmethod
    def find_spec(fullname, target=None):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN205 - as above
        """Return None: the folder is for editors."""
        del fullname, target


def _other_spec(name, target):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202 - as above
    for finder in sys.meta_path:
        spec = None if finder is _Finder else finder.find_spec(name, None, target)
        if spec is not None:
            return spec
    return None


def _spec_of_zbot(name, target):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202 - as above
    # From Python 3.14 on, an import does not ask the finders that were added while it searches.
    # `zbot.package.import_finder` knows this function by its name, and raises its errors here.
    for finder in sys.meta_path:
        spec = finder.find_spec(name, None, target)
        if spec is not None:
            return spec
    return None


def is_known(name: str) -> bool:
    """Return whether zbot may have a top-level package of this name, or know what replaces it."""
    return name in NAMES or name in _OF_ROS_1 or name.endswith(_SUFFIXES)


def _prefers_zbot() -> bool:
    """Return whether zbot's packages win over those of a real ROS 2. See `import_finder`."""
    import os  # noqa: PLC0415 - Python has loaded it, except with -S

    return os.environ.get("ZBOT_RCLPY") == "zbot"


def _is_sourced(name: str) -> bool:
    """Return whether the name may be a package of a workspace that was sourced."""
    if name in sys.stdlib_module_names or name[:1] == "_" or name in _OF_SITE:
        return False
    if name == _OF_FINDER:
        return False
    import os  # noqa: PLC0415 - Python has loaded it, except with -S

    return bool(os.environ.get("ZBOT_WORKSPACE"))


def remove() -> None:
    """Remove the finder from `sys.meta_path`. `zbot.compat` has finders of its own."""
    if _Finder in sys.meta_path:
        sys.meta_path.remove(_Finder)


def _folder_of_types(path):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202 - as above
    """Return the finder for a folder with types, also of another copy of zbot on `sys.path`.

    Python calls this function for each new folder on `sys.path`.

    Raises:
        ImportError: The folder has no types of zbot: Python calls the next hook.
    """
    if not path.endswith(_TYPES):
        raise ImportError(path)
    return _Nothing


def _install() -> None:
    home = __file__.rpartition("zbot_ros2_names")[0][:-1]
    sys.path_hooks.insert(0, _folder_of_types)
    sys.path.extend(home + folder for folder in _TYPES)
    sys.meta_path.insert(0, _Finder)


_install()
