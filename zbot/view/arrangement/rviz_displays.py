"""Table of rviz's displays: which of their properties are settings of the view's displays."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.view.arrangement.property_form import (
    Choice,
    Flag,
    Form,
    Frame,
    Hidden,
    Number,
    Rgb,
    Text,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    #: The properties of a display by path, e.g. `Shape/Color`.
    Properties = dict[str, Any]

_METRES_A_PIXEL = 0.01
_THIN_PX = 2.0
_LARGEST = 1e6
_AXIS_LENGTH_OF_TF = 0.2  #: of rviz's frames at the scale 1
_SHAFT = 0.77  #: share of an arrow that is its shaft


class Entry(NamedTuple):
    """Property of a display, and the setting that it is."""

    path: str
    setting: str
    form: Form


def _unchanged(found: Properties) -> Properties:
    return found


@dataclass(frozen=True)
class RvizDisplay:
    """Display of rviz.

    Attributes:
        kind: The name of the view's display.
        entries: The properties that are settings.
        usual: Properties that the view does not have, with the value with which they change
            nothing.
        unneeded: Properties that change nothing in the view. What is below them does not either.
        combine: Makes one property of several ones, after reading.
        split: Does the reverse, before writing.
    """

    kind: str
    entries: tuple[Entry, ...] = ()
    usual: Mapping[str, Any] = field(default_factory=dict)
    unneeded: frozenset[str] = frozenset()
    combine: Callable[[Properties], Properties] = _unchanged
    split: Callable[[Properties], Properties] = _unchanged


#: Properties of all displays that change nothing here: the view reads each topic with a profile
#: that fits its publishers.
UNNEEDED = frozenset(
    (
        *("Class", "Enabled", "Name", "Value", "Queue Size", "Unreliable", "Transport Hint"),
        *("Topic", "Image Topic", "Marker Topic", "Description Topic", "Robot Description"),
        *("Update Topic", "Interactive Markers Namespace"),
    )
)
_OPAQUE = {"Alpha": 1}


def _cloud_combined(found: Properties) -> Properties:
    """Join the colouring with its axis, and the style with its size."""
    made = dict(found)
    if made.get("Color Transformer") == "AxisColor":
        made["Color Transformer"] = f"AxisColor {made.get('Axis', 'Z')}"
    pixels = made.get("Size (Pixels)")
    if made.get("Style") == "Points" and isinstance(pixels, (int, float)):
        made["Size (m)"] = pixels * _METRES_A_PIXEL
    return made


def _cloud_split(made: Properties) -> Properties:
    transformer, _, axis = str(made.get("Color Transformer", "")).partition(" ")
    if transformer:
        made["Color Transformer"] = transformer
    return {**made, "Axis": axis} if axis else made


def _cloud(kind: str, ways: Mapping[str, str]) -> RvizDisplay:
    styles = {"Flat Squares": "square", "Spheres": "circle"}
    return RvizDisplay(
        kind,
        (
            Entry("Style", "shape", Choice({**styles, **dict.fromkeys(_STYLES, "square")})),
            Entry("Size (m)", "size", Number()),
            Entry("Color Transformer", "color by", Choice(ways)),
            Entry("Color", "color", Rgb()),
            Entry("Decay Time", "decay time", Number()),
        ),
        {**_OPAQUE, "Invert Rainbow": False, "Use rainbow": True}
        | {"Autocompute Intensity Bounds": True, "Autocompute Value Bounds/Value": True},
        frozenset(
            (
                *("Axis", "Channel Name", "Position Transformer", "Selectable", "Use Fixed Frame"),
                *("Max Color", "Min Color", "Max Intensity", "Min Intensity", "Size (Pixels)"),
                *("Autocompute Value Bounds/Max Value", "Autocompute Value Bounds/Min Value"),
            )
        ),
        _cloud_combined,
        _cloud_split,
    )


_STYLES = ("Points", "Squares", "Boxes", "Tiles")
_OF_CLOUD = {
    "": "auto",
    "Intensity": "intensity",
    "RGB8": "rgb",
    "RGBF32": "rgb",
    "AxisColor Z": "z",
    "AxisColor X": "x",
    "AxisColor Y": "y",
    "FlatColor": "flat",
}
_OF_SCAN = {
    "FlatColor": "flat",
    "": "intensity",
    "Intensity": "intensity",
    "AxisColor X": "x",
    "AxisColor Y": "y",
    "AxisColor Z": "flat",
    "RGB8": "flat",
}


def _arrow_combined(found: Properties) -> Properties:
    """Make one length of the lengths of an arrow's parts, or take that of the axes."""
    start = "Shape/" if "Shape/Value" in found else ""
    shape = str(found.get("Shape/Value" if start else "Shape", ""))
    names: tuple[str, ...] = ("Shaft Length", "Head Length")
    if shape.startswith("Axes"):
        names = ("Axes Length",)
    elif shape == "Arrow (Flat)":
        names = ("Arrow Length",)
    parts = [_number(found.get(f"{start}{name}")) for name in names]
    return {**found, "Whole Length": sum(parts)} if all(parts) else found


def _number(raw: Any) -> float:
    return float(raw) if isinstance(raw, (int, float)) and 0 < raw < _LARGEST else 0.0


def _arrow_split(start: str) -> Callable[[Properties], Properties]:
    def split(made: Properties) -> Properties:
        length = made.pop("Whole Length", None)
        if length is not None:
            made[f"{start}Shaft Length"] = round(length * _SHAFT, 6)
            made[f"{start}Head Length"] = round(length * (1 - _SHAFT), 6)
            made[f"{start}Axes Length"] = length
            if not start:
                made["Arrow Length"] = length
        return made

    return split


_SIZES = ("Axes Length", "Axes Radius", "Head Length", "Head Radius", "Shaft Length")
_ARROW_SIZES = frozenset((*_SIZES, "Shaft Radius", "Arrow Length", "Max Arrow Length"))
_IN_SHAPE = frozenset(f"Shape/{name}" for name in _ARROW_SIZES)
_LENGTH = Entry("Whole Length", "length", Number())
_COLOR = Entry("Color", "color", Rgb())
_SHAPES = Choice({"Arrow": "arrow", "Axes": "axes"})
_MANY_SHAPES = Choice({"Arrow (Flat)": "arrow", "Arrow (3D)": "arrow", "Axes": "axes"})
_POSES = (Entry("Shape", "shape", _MANY_SHAPES), _LENGTH, _COLOR)


def _part_combined(found: Properties) -> Properties:
    """Make one word of the switches of the visual and the collision parts."""
    is_visual = found.get("Visual Enabled", True) is not False
    is_collision = found.get("Collision Enabled", False) is True
    both = "both" if is_visual else "collision"
    return {**found, "Part": both if is_collision else "visual"}


def _part_split(made: Properties) -> Properties:
    part = made.pop("Part", "visual")
    shown = {"Visual Enabled": part != "collision", "Collision Enabled": part != "visual"}
    return {**made, **shown}


def _width_combined(found: Properties) -> Properties:
    """Make a width in pixels: rviz's thin lines have no width."""
    width = _number(found.get("Line Width")) if found.get("Line Style") == "Billboards" else 0.0
    pixels = min(max(width / _METRES_A_PIXEL, 1.0), 10.0) if width else _THIN_PX
    made = {**found, "Pixels": pixels}
    if made.get("Pose Style") == "Arrows":
        made["Length"] = sum(_number(made.get(name)) for name in ("Shaft Length", "Head Length"))
    return made


def _width_split(made: Properties) -> Properties:
    width = made.pop("Pixels", _THIN_PX) * _METRES_A_PIXEL
    return {**made, "Line Style": "Billboards", "Line Width": width}


_POSE_STYLES = Choice({"None": "none", "Axes": "axes", "Arrows": "arrow"})
_NO_OFFSET = {"Offset/X": 0, "Offset/Y": 0, "Offset/Z": 0}
_IMAGE = frozenset(("Max Value", "Median window", "Min Value", "Normalize Range"))
_CAMERA = frozenset(
    ("Image Rendering", "Overlay Alpha", "Visibility", "Zoom Factor", "Far Plane Distance")
)
_NAMES = Entry("Namespaces", "hidden", Hidden())


def _vectors(kind: str, straight: str, turning: str) -> RvizDisplay:
    return RvizDisplay(
        kind,
        (
            Entry(f"{straight} Arrow Scale", "scale", Number()),
            Entry(f"{straight} Color", "color", Rgb()),
            Entry(f"{turning} Color", "color of turning", Rgb()),
        ),
        {**_OPAQUE, "History Length": 1},
        frozenset(("Arrow Width", "Accept NaN Values", "Hide Small Values"))
        | {f"{turning} Arrow Scale"},
    )


_TEXT = RvizDisplay("Text", (), {}, _cloud("", {}).unneeded | {"Style", "Size (m)", "Color"})

#: The displays that the view has, by the last part of their class in rviz.
RVIZ_DISPLAYS: Mapping[str, RvizDisplay] = {
    "Grid": RvizDisplay(
        "Grid",
        (
            Entry("Cell Size", "cell size", Number()),
            Entry("Plane Cell Count", "cells", Number()),
            Entry("Plane", "plane", Choice({name: name for name in ("XY", "XZ", "YZ")})),
            Entry("Offset/Z", "height", Number(low=-1e6)),
            Entry("Color", "color", Rgb()),
            Entry("Reference Frame", "frame", Frame()),
        ),
        {"Normal Cell Count": 0, "Offset/X": 0, "Offset/Y": 0},
        frozenset(("Alpha", "Line Style")),
    ),
    "Axes": RvizDisplay(
        "Axes",
        (Entry("Length", "length", Number()), Entry("Reference Frame", "frame", Frame())),
        {**_OPAQUE, "Show Trail": False},
        frozenset(("Radius",)),
    ),
    "TF": RvizDisplay(
        "TF",
        (
            Entry("Marker Scale", "length", Number(_AXIS_LENGTH_OF_TF)),
            Entry("Show Axes", "axes", Flag()),
            Entry("Show Names", "names", Flag()),
            Entry("Show Arrows", "lines", Flag()),
            Entry("Frames", "hidden", Hidden(is_nested=True)),
        ),
        {"Filter (blacklist)": "", "Filter (whitelist)": ""},
        frozenset(("Frame Timeout", "Tree", "Update Interval", "Marker Alpha")),
    ),
    "RobotModel": RvizDisplay(
        "RobotModel",
        (
            Entry("Part", "part", Choice({name: name for name in ("visual", "collision", "both")})),
            Entry("Alpha", "opacity", Number()),
            Entry("TF Prefix", "tf prefix", Text()),
            Entry("Links", "hidden", Hidden(is_nested=True)),
        ),
        {"Mass Properties/Inertia": False, "Mass Properties/Mass": False},
        frozenset(("Visual Enabled", "Collision Enabled", "Update Interval"))
        | {"Description File", "Description Source"},
        _part_combined,
        _part_split,
    ),
    "LaserScan": _cloud("LaserScan", _OF_SCAN),
    "PointCloud2": _cloud("PointCloud2", _OF_CLOUD),
    "Map": RvizDisplay(
        "Map",
        (
            Entry("Color Scheme", "color", Choice({"map": "map", "costmap": "costmap"})),
            Entry("Alpha", "opacity", Number()),
        ),
        {"Binary representation": False},
        frozenset(("Binary threshold", "Draw Behind", "Update Topic", "Use Timestamp")),
    ),
    "Image": RvizDisplay("Image", (), {}, _IMAGE),
    "Camera": RvizDisplay("Image", (), {}, _IMAGE | _CAMERA),
    "Odometry": RvizDisplay(
        "Odometry",
        (
            Entry("Shape/Value", "shape", _SHAPES),
            Entry("Shape/Color", "color", Rgb()),
            Entry("Covariance/Value", "covariance", Flag()),
            Entry("Keep", "line", Number()),
            _LENGTH,
        ),
        {"Shape/Alpha": 1},
        _IN_SHAPE | {"Angle Tolerance", "Position Tolerance", "Covariance"},
        _arrow_combined,
        _arrow_split("Shape/"),
    ),
    "Path": RvizDisplay(
        "Path",
        (
            Entry("Pixels", "width", Number()),
            Entry("Color", "color", Rgb()),
            Entry("Pose Color", "color of poses", Rgb()),
            Entry("Length", "length", Number()),
            Entry("Pose Style", "poses", _POSE_STYLES),
        ),
        {**_OPAQUE, "Buffer Length": 1, **_NO_OFFSET},
        frozenset(("Head Diameter", "Head Length", "Line Style", "Line Width", "Radius"))
        | {"Shaft Diameter", "Shaft Length"},
        _width_combined,
        _width_split,
    ),
    "Pose": RvizDisplay(
        "Pose",
        (Entry("Shape", "shape", _SHAPES), _LENGTH, _COLOR),
        _OPAQUE,
        _ARROW_SIZES,
        _arrow_combined,
        _arrow_split(""),
    ),
    "PoseWithCovariance": RvizDisplay(
        "PoseWithCovariance",
        (
            Entry("Shape", "shape", _SHAPES),
            Entry("Covariance/Value", "covariance", Flag()),
            _LENGTH,
            _COLOR,
        ),
        _OPAQUE,
        _ARROW_SIZES | {"Covariance"},
        _arrow_combined,
        _arrow_split(""),
    ),
    "PoseArray": RvizDisplay(
        "PoseArray", _POSES, _OPAQUE, _ARROW_SIZES, _arrow_combined, _arrow_split("")
    ),
    "ParticleCloud": RvizDisplay(
        "ParticleCloud",
        (
            Entry("Shape", "shape", _MANY_SHAPES),
            Entry("Max Arrow Length", "length", Number()),
            _COLOR,
        ),
        _OPAQUE,
        frozenset(("Min Arrow Length",)),
    ),
    "Marker": RvizDisplay("Marker", (_NAMES,)),
    "MarkerArray": RvizDisplay("MarkerArray", (_NAMES,)),
    "InteractiveMarkers": RvizDisplay(
        "InteractiveMarkers",
        (Entry("Show Descriptions", "names", Flag()),),
        {"Show Axes": False},
        frozenset(("Enable Transparency", "Show Visual Aids")),
    ),
    "Polygon": RvizDisplay("Polygon", (_COLOR,), _OPAQUE),
    "Range": RvizDisplay(
        "Range", (_COLOR, Entry("Alpha", "opacity", Number())), {"Buffer Length": 1}
    ),
    "GridCells": RvizDisplay("GridCells", (_COLOR,), _OPAQUE),
    "Wrench": _vectors("Wrench", "Force", "Torque"),
    "WrenchStamped": _vectors("Wrench", "Force", "Torque"),
    "TwistStamped": _vectors("Twist", "Linear", "Angular"),
    "AccelStamped": _vectors("Accel", "Linear", "Angular"),
    "PointStamped": RvizDisplay(
        "PointStamped",
        (_COLOR, Entry("Radius", "radius", Number())),
        {**_OPAQUE, "History Length": 1},
    ),
    **dict.fromkeys(("FluidPressure", "Illuminance", "RelativeHumidity", "Temperature"), _TEXT),
}
