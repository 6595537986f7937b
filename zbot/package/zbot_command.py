"""Command line that starts zbot in child processes, and wrappers, e.g. `ros2`, that run zbot.

A wrapper is a small script with the name of a missing program. Programs and launch files start
commands such as `ros2 topic echo ...`. If ROS 2 is not installed, the PATH ends with a folder that
contains the wrapper `ros2`.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import shlex
import shutil
import stat
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.package.bundled_nodes import BUNDLED_PROGRAMS
from zbot.package.errors import WrapperError
from zbot.package.unavailable import unavailable_program
from zbot.package.user_folders import cache_folder, make_private

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


def zbot_command() -> list[str]:
    """Return the words that start the `zbot` of this Python installation."""
    # The script `zbot` is better than `-m zbot`, which adds the working directory to sys.path. But
    # on Windows, zbot.exe starts a second process, and signals do not reach that process.
    script = Path(sys.executable).with_name("zbot")
    if os.name != "nt" and script.is_file() and os.access(script, os.X_OK):
        return [str(script)]
    return [sys.executable, "-m", "zbot"]


def run_scripts_with_zbot(words: Sequence[str]) -> list[str]:
    """Replace `python3 X.py` by `zbot run X.py` in a command, so that the script finds `rclpy`.

    If a program of rqt or `xacro` is not on the PATH, run zbot's own program of this name instead.
    """
    package = BUNDLED_PROGRAMS.get(words[0])
    is_missing = package is not None and shutil.which(words[0]) is None
    if package is not None and is_missing and unavailable_program(words[0]) is None:
        return [*zbot_command(), "run", package, *words]
    script = 2 if len(words) > 1 and words[1] == "-u" else 1  # zbot does not need -u
    is_python = words[0] in {sys.executable, "python", "python3"}
    if is_python and len(words) > script and words[script].endswith(".py"):
        return [*zbot_command(), "run", *words[script:]]
    return list(words)


def find_on_path(name: str, environment: Mapping[str, str]) -> str | None:
    """Return the path of a program or of its wrapper. Return None if neither exists.

    A missing `ros2`, `zbot`, `rviz2` or rqt program has a wrapper. The wrapper of an rqt program
    opens zbot's web page, and that of `rviz2` opens the 3D view. If this Python installation has
    xacro, a wrapper starts it even if another `xacro` is on the PATH, because only the xacro of
    this installation finds zbot's packages.
    """
    if name == "xacro" and importlib.util.find_spec("xacro") is not None:
        return str(executable_wrapper("xacro", "xacro"))
    found = shutil.which(name, path=environment.get("PATH"))
    if found is None and name in BUNDLED_PROGRAMS and unavailable_program(name) is None:
        return str(executable_wrapper(BUNDLED_PROGRAMS[name], name))
    if found is None and Path(name).name in {"ros2", "zbot"}:
        found = str(_wrapper(Path(name).name, zbot_command()))
    return found


def add_ros2_to_path(environment: Mapping[str, str]) -> dict[str, str]:
    """Return an environment whose PATH has `ros2`, `zbot` and `xacro`, or wrappers for them."""
    path = environment.get("PATH", os.defpath)
    missing = [name for name in ("ros2", "zbot") if shutil.which(name, path=path) is None]
    folders = {str(_wrapper(name, zbot_command()).parent) for name in missing}
    if shutil.which("xacro", path=path) is None:
        folders.add(str(executable_wrapper("xacro", "xacro").parent))
    return {**environment, "PATH": os.pathsep.join((path, *sorted(folders)))}


def executable_wrapper(package: str, executable: str) -> Path:
    """Return the path of a wrapper that runs an executable of a package."""
    return _wrapper(executable, [*zbot_command(), "run", package, executable])


def _wrapper(name: str, words: Sequence[str]) -> Path:
    """Return the path of a wrapper, which runs a command and adds its own arguments to it."""
    key = hashlib.sha256("\0".join(words).encode()).hexdigest()[:16]
    path = cache_folder() / "programs" / key / (f"{name}.cmd" if os.name == "nt" else name)
    try:
        if not path.is_file():
            _write(path, words)
    except OSError as error:
        raise WrapperError(path, error) from error
    return path


def _write(path: Path, words: Sequence[str]) -> None:
    make_private(path.parent)
    if os.name == "nt":
        line = " ".join(f'"{word}"' for word in words)
        path.write_text(f"@{line} %*\n", encoding="utf-8")
        return
    # Write the file under another name and rename it when it is complete, because another launch
    # may start it immediately.
    draft = path.with_name(f"{path.name}.{os.getpid()}")
    draft.write_text(f'#!/bin/sh\nexec {shlex.join(words)} "$@"\n', encoding="utf-8")
    draft.chmod(draft.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
    draft.replace(path)
