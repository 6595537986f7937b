"""Catalog of the robots that zbot contains, and reader of files with other robots."""

from __future__ import annotations

import subprocess
import sys
from importlib.resources import files
from pathlib import Path

from zbot.errors.suggestion import did_you_mean
from zbot.libraries.robot_description.file import read_description
from zbot.simulation.errors import SimulationError
from zbot.simulation.robots.model import RobotModel, read_robot

_XACRO_TIMEOUT_S = 30.0
_ENDINGS = (".urdf", ".xacro", ".xml")


def robot_names() -> list[str]:
    """Return the names of the robots that zbot contains."""
    folder = files("zbot.simulation.robots") / "files"
    names = (file.name for file in folder.iterdir() if file.name.endswith(".urdf"))
    return sorted(name.removesuffix(".urdf") for name in names)


def find_robot(name: str) -> RobotModel:
    """Return the robot of a name, or of a file in URDF or for xacro.

    Raises:
        SimulationError: There is no such robot or file, or it cannot be simulated.
        DescriptionError: The file is not a valid description.
    """
    known = robot_names()
    if name in known:
        text = (files("zbot.simulation.robots") / "files" / f"{name}.urdf").read_text("utf-8")
        return read_robot(text)
    path = Path(name)
    if path.suffix not in _ENDINGS:
        hint = did_you_mean(name, known, before="; ")
        raise SimulationError(
            f"there is no robot '{name}'{hint} (robots: {', '.join(known)}, or a file .urdf)"
        )
    is_macro = path.suffix == ".xacro" or "<xacro:" in read_description(path)
    return read_robot(expanded(path) if is_macro else read_description(path))


def expanded(path: Path) -> str:
    """Return the output of xacro, which runs in a process of its own.

    Raises:
        SimulationError: xacro fails, or does not end.
    """
    words = [sys.executable, "-m", "zbot_cli", "run", "xacro", "xacro", str(path)]
    try:
        done = subprocess.run(  # noqa: S603 - the user names the file
            words, capture_output=True, text=True, timeout=_XACRO_TIMEOUT_S, check=False
        )
    except subprocess.TimeoutExpired as error:
        raise SimulationError(f"xacro did not end within {_XACRO_TIMEOUT_S:.0f} s") from error
    if done.returncode:
        lines = done.stderr.strip().splitlines() or ["it said nothing"]
        # After the reason, xacro says in which files it was.
        reason = next((line for line in lines if line.startswith("error: ")), lines[-1])
        raise SimulationError(f"xacro cannot read {path}: {reason.removeprefix('error: ')[:500]}")
    return done.stdout
