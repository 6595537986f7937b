"""Command lines of Gazebo's programs, whose options have one dash, as `-name bot`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.urdf import quaternion

from geometry_msgs.msg import Pose, Quaternion

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence


def read_options(
    words: Sequence[str], flags: Collection[str] = ()
) -> tuple[dict[str, str], list[str]]:
    """Return the options of a command line with their values, and the other words.

    Args:
        words: The words after the name of the program.
        flags: Options that may have no value.
    """
    options: dict[str, str] = {}
    others: list[str] = []
    rest = list(words)
    while rest:
        word = rest.pop(0)
        if not word.startswith("-") or _is_number(word) or word == "-":
            others += [word] if word else []
            continue
        name, equals, value = word.lstrip("-").partition("=")
        if not equals:
            is_next = bool(rest) and (not rest[0].startswith("-") or _is_number(rest[0]))
            is_truth = is_next and rest[0].lower() in {"true", "false", "0", "1"}
            value = rest.pop(0) if is_next and (name not in flags or is_truth) else "true"
        options[name] = value
    return options, others


def is_set(options: dict[str, str], name: str) -> bool:
    """Return whether a flag is given and not false."""
    return options.get(name, "false").lower() in {"true", "1"}


def number(options: dict[str, str], name: str) -> float:
    """Return an option as a number, or 0 if it is not given.

    Raises:
        SystemExit: The value is not a finite number.
    """
    text = options.get(name, "0") or "0"
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise SystemExit(f"error: -{name} must be a number, not '{text}'")
    return value


def pose(options: dict[str, str]) -> Pose:
    """Return the pose in the options x, y, z, R, P and Y."""
    found = Pose()
    at = found.position
    at.x, at.y, at.z = (number(options, name) for name in "xyz")
    x, y, z, w = quaternion(*(number(options, name) for name in "RPY"))
    found.orientation = Quaternion(x=x, y=y, z=z, w=w)
    return found


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
