"""Choice between zbot's rclpy and a genuine one in the same Python.

A genuine rclpy is that of ROS 2. It is installed beside zbot, or ROS 2 was sourced in the terminal.
"""

from __future__ import annotations

import os
from importlib.machinery import PathFinder
from pathlib import Path

from zbot.package import import_finder
from zbot.package.errors import NoGenuineRclpyError

_ZBOT, _GENUINE = "zbot", "genuine"


def choose_rclpy(*, is_genuine: bool) -> str:
    """Choose the rclpy, and all other names of ROS 2, of this process and its child processes.

    Args:
        is_genuine: Whether the user wants the genuine rclpy. If not, ZBOT_RCLPY=genuine of a parent
            process is obeyed.

    Returns:
        A note that a genuine rclpy is passed by, or an empty string. A child process of a process
        with this note has none.

    Raises:
        NoGenuineRclpyError: The genuine rclpy is chosen, but is not installed.
    """
    chosen = os.environ.get(import_finder.VARIABLE)
    is_genuine = is_genuine or chosen == _GENUINE
    folder = genuine_rclpy()
    if is_genuine and not folder:
        raise NoGenuineRclpyError
    os.environ[import_finder.VARIABLE] = _GENUINE if is_genuine else _ZBOT
    import_finder.prefer_zbot(not is_genuine)
    if is_genuine or not folder or chosen:
        return ""
    return (
        f"programs use zbot's rclpy, not the genuine one in {folder}: `--genuine` chooses that one"
    )


def genuine_rclpy() -> Path | None:
    """Return the folder of the genuine rclpy that Python finds, or None."""
    found = PathFinder.find_spec("rclpy")
    return Path(found.origin).parent if found and found.origin else None
