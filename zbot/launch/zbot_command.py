"""How a child is told to be zbot: its command line, and programs that stand in for `ros2`.

Launch files start `ros2 topic echo ...` and the like. Where no ROS 2 is installed, a folder with a
program `ros2` that is zbot comes last on the children's search path.
"""

from __future__ import annotations

import hashlib
import os
import shlex
import shutil
import stat
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.launch.errors import ProgramError
from zbot.package.view import cache_folder

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


def own_command() -> list[str]:
    """Return the words that start the `zbot` of this Python."""
    # The script leaves the current folder off Python's path; Windows' .exe would be one process
    # more, which signals do not pass through.
    script = Path(sys.executable).with_name("zbot")
    if os.name != "nt" and script.is_file() and os.access(script, os.X_OK):
        return [str(script)]
    return [sys.executable, "-m", "zbot"]


def for_scripts(words: Sequence[str]) -> list[str]:
    """Return the words that run a program; a script that is given to Python finds ROS 2's names."""
    script = 2 if len(words) > 1 and words[1] == "-u" else 1  # children are never buffered
    is_python = words[0] in {sys.executable, "python", "python3"}
    if is_python and len(words) > script and words[script].endswith(".py"):
        return [*own_command(), "run", *words[script:]]
    return list(words)


def find_on_path(name: str, environment: Mapping[str, str]) -> str | None:
    """Return the path of a program as a child with this environment would find it."""
    found = shutil.which(name, path=environment.get("PATH"))
    if found is None and Path(name).name in {"ros2", "zbot"}:
        found = str(_stand_in(Path(name).name, own_command()))
    return found


def with_ros2(environment: Mapping[str, str]) -> dict[str, str]:
    """Return an environment in which `ros2` and `zbot` are found: ROS 2's own, or this zbot."""
    path = environment.get("PATH", os.defpath)
    missing = [name for name in ("ros2", "zbot") if shutil.which(name, path=path) is None]
    folders = {str(_stand_in(name, own_command()).parent) for name in missing}
    return {**environment, "PATH": os.pathsep.join((path, *sorted(folders)))}


def program_file(package: str, executable: str) -> Path:
    """Return a program that runs an executable of a package."""
    return _stand_in(executable, [*own_command(), "run", package, executable])


def _stand_in(name: str, words: Sequence[str]) -> Path:
    """Return a program of that name which runs a command with its own arguments added."""
    key = hashlib.sha256("\0".join(words).encode()).hexdigest()[:16]
    path = cache_folder() / "programs" / key / (f"{name}.cmd" if os.name == "nt" else name)
    try:
        if not path.is_file():
            _write(path, words)
    except OSError as error:
        raise ProgramError(f"cannot write {path}: {error.strerror}") from error
    return path


def _write(path: Path, words: Sequence[str]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if os.name == "nt":
        line = " ".join(f'"{word}"' for word in words)
        path.write_text(f"@{line} %*\n", encoding="utf-8")
        return
    # Renamed when it is whole: another launch may start it at this moment.
    draft = path.with_name(f"{path.name}.{os.getpid()}")
    draft.write_text(f'#!/bin/sh\nexec {shlex.join(words)} "$@"\n', encoding="utf-8")
    draft.chmod(draft.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
    draft.replace(path)
