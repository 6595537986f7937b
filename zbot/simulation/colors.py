"""Colours by the names that Gazebo's files use, e.g. `Gazebo/Red`."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.libraries.robot_description.appearance import Rgba

_COLORS: dict[str, tuple[float, float, float]] = {
    "black": (0.05, 0.05, 0.05),
    "darkgrey": (0.2, 0.2, 0.2),
    "grey": (0.7, 0.7, 0.7),
    "white": (1.0, 1.0, 1.0),
    "flatblack": (0.1, 0.1, 0.1),
    "red": (0.9, 0.1, 0.1),
    "redbright": (0.95, 0.1, 0.1),
    "green": (0.1, 0.8, 0.1),
    "blue": (0.1, 0.1, 0.9),
    "skyblue": (0.13, 0.44, 0.7),
    "yellow": (0.95, 0.9, 0.1),
    "zincyellow": (0.97, 0.95, 0.1),
    "darkyellow": (0.7, 0.7, 0.1),
    "orange": (1.0, 0.5, 0.1),
    "purple": (0.8, 0.1, 0.9),
    "turquoise": (0.1, 0.9, 0.9),
    "gold": (0.8, 0.65, 0.15),
    "indigo": (0.33, 0.1, 0.8),
    "wood": (0.62, 0.44, 0.26),
    "bricks": (0.6, 0.3, 0.22),
    "grass": (0.2, 0.5, 0.15),
    "road": (0.3, 0.3, 0.3),
}


def color_of(name: str) -> Rgba | None:
    """Return the colour of a name such as `Gazebo/Red`, or None if it is not known."""
    found = _COLORS.get(name.rpartition("/")[2].lower())
    return None if found is None else (*found, 1.0)
