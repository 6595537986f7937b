"""Views of rviz: where its camera is, as in an `.rviz` file."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.view.arrangement.property_form import Frame, PropertyError
from zbot.view.camera import ANGLE, Camera

if TYPE_CHECKING:
    from collections.abc import Mapping

_LARGEST = 1e6
_USUAL_HEIGHT_PX = 800.0
_ORBITS = ("Orbit", "XYOrbit", "ThirdPersonFollower")


def camera_of(raw: Mapping[str, Any], window: Mapping[str, Any]) -> tuple[Camera | None, str]:
    """Return the camera of a view, or None, and what the view does not have.

    Args:
        raw: The properties of the view.
        window: The properties of rviz's window. Its height says what a view from above shows.
    """
    name = str(raw.get("Class", "")).rpartition("/")[2]
    try:
        target = str(Frame().read(raw.get("Target Frame"))).removeprefix("/")
    except PropertyError:
        target = ""
    if name in _ORBITS:
        return _orbit(raw, target, turns=name == "ThirdPersonFollower"), ""
    if name == "TopDownOrtho":
        return _from_above(raw, window, target), ""
    return None, f"view {name}" if name else ""


def _orbit(raw: Mapping[str, Any], target: str, *, turns: bool) -> Camera:
    point = raw.get("Focal Point")
    focal = point if isinstance(point, dict) else {}
    focus = tuple(_number(focal.get(axis), 0.0) for axis in "XYZ")
    distance = max(_number(raw.get("Distance"), 10.0), 0.01)
    yaw, pitch = _number(raw.get("Yaw"), math.pi / 4), _number(raw.get("Pitch"), math.pi / 4)
    return Camera((focus[0], focus[1], focus[2]), distance, yaw, pitch, target, turns)


def _from_above(raw: Mapping[str, Any], window: Mapping[str, Any], target: str) -> Camera:
    """Return a camera above the point (X, Y), which shows as many metres as rviz does."""
    height_px = max(_number(window.get("Height"), _USUAL_HEIGHT_PX), 100.0)
    scale = max(abs(_number(raw.get("Scale"), 10.0)), 0.01)  # pixels a metre
    distance = height_px / scale / 2 / math.tan(ANGLE / 2)
    focus = (_number(raw.get("X"), 0.0), _number(raw.get("Y"), 0.0), 0.0)
    yaw = _number(raw.get("Angle"), 0.0) - math.pi / 2
    return Camera(focus, distance, yaw, math.pi / 2, target)


def view_properties(camera: Camera) -> dict[str, Any]:
    """Return the properties of rviz's view with a camera."""
    x, y, z = (round(part, 4) for part in camera.focus)
    name = "ThirdPersonFollower" if camera.turns else "Orbit"
    return {
        "Class": f"rviz_default_plugins/{name}",
        "Distance": round(camera.distance, 4),
        "Focal Point": {"X": x, "Y": y, "Z": z},
        "Name": "Current View",
        "Near Clip Distance": 0.01,
        "Pitch": round(camera.pitch, 4),
        "Target Frame": camera.target or "<Fixed Frame>",
        "Value": f"{name} (rviz_default_plugins)",
        "Yaw": round(camera.yaw % math.tau, 4),
    }


def _number(raw: Any, otherwise: float) -> float:
    is_number = isinstance(raw, (int, float)) and not isinstance(raw, bool)
    return float(raw) if is_number and abs(raw) < _LARGEST else otherwise
