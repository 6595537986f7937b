"""Shapes that displays make from messages. Lengths are in metres, colours have 8 bits a channel."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float32]
    Bytes = NDArray[np.uint8]

Color = tuple[int, int, int]
#: How a point of a cloud is drawn.
POINT_SHAPES = ("square", "circle")


@dataclass(frozen=True, eq=False)
class Points:
    """Cloud of points."""

    positions: Floats  #: shape (n, 3)
    colors: Bytes  #: shape (n, 3)
    size: float = 0.03
    shape: str = "square"  #: one of `POINT_SHAPES`


@dataclass(frozen=True, eq=False)
class Lines:
    """Separate pieces of lines."""

    ends: Floats  #: shape (n, 2, 3): the two ends of each piece
    colors: Bytes  #: shape (n, 2, 3)
    width_px: float = 2.0


@dataclass(frozen=True, eq=False)
class Arrows:
    """Arrows of one thickness."""

    ends: Floats  #: shape (n, 2, 3): the tail and the tip of each arrow
    colors: Bytes  #: shape (n, 3)
    shaft_radius: float = 0.02
    head_radius: float = 0.05
    head_length: float = 0.1


@dataclass(frozen=True, eq=False)
class Axes:
    """Coordinate axes: x is red, y is green and z is blue."""

    poses: tuple[Rigid, ...]
    length: float = 0.3


@dataclass(frozen=True, eq=False)
class Mesh:
    """Surface of triangles."""

    vertices: Floats  #: shape (n, 3)
    faces: NDArray[np.uint32]  #: shape (m, 3): the numbers of each triangle's vertices
    color: Color = (160, 160, 160)
    opacity: float = 1.0
    pose: Rigid = field(default_factory=Rigid)
    has_levels: bool = False  #: whether fewer triangles may be drawn from afar; this takes a moment


@dataclass(frozen=True, eq=False)
class Copies:
    """Copies of one surface, each with its own place, size and colour."""

    vertices: Floats  #: shape (n, 3)
    faces: NDArray[np.uint32]  #: shape (m, 3)
    positions: Floats  #: shape (copies, 3)
    scales: Floats  #: shape (copies, 3)
    colors: Bytes  #: shape (copies, 3)
    opacity: float = 1.0


@dataclass(frozen=True, eq=False)
class Label:
    """Text that always faces the user."""

    text: str
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    height: float = 0.0  #: height of a letter in metres; 0 means the same size at every distance


@dataclass(frozen=True, eq=False)
class Plane:
    """Picture on a rectangle. Its first row is at the edge with the largest y."""

    pixels: Bytes  #: shape (rows, columns, 3), or 4 with an opacity
    width: float
    height: float
    pose: Rigid  #: of the centre of the rectangle


@dataclass(frozen=True, eq=False)
class Picture:
    """Picture beside the scene."""

    data: bytes
    media_type: str  #: e.g. `image/jpeg`


@dataclass(frozen=True, eq=False)
class Frustum:
    """Pyramid of what a camera sees, with its picture. z is the direction of the camera."""

    picture: Picture
    vertical_angle: float  #: in rad


@dataclass(frozen=True, eq=False)
class Gizmo:
    """Handles with which a user moves and turns something.

    `moved` is called in a thread of the drawing, with `start`, `update` or `end`, and with the
    movement since the handles were drawn.
    """

    moved: Callable[[str, Rigid], None]
    axes: tuple[bool, bool, bool] = (True, True, True)
    has_arrows: bool = True
    has_squares: bool = True
    has_rings: bool = True
    scale: float = 1.0


@dataclass(frozen=True, eq=False)
class Note:
    """Line of text beside the scene."""

    text: str


Shape = (
    Points
    | Lines
    | Arrows
    | Axes
    | Mesh
    | Copies
    | Label
    | Plane
    | Picture
    | Frustum
    | Gizmo
    | Note
)


class Item(NamedTuple):
    """Shapes in one frame.

    A display that keeps an item gives the same object again: only new objects are drawn.
    """

    frame: str  #: the frame of the shapes' coordinates. An empty name means the fixed frame.
    stamp_ns: int  #: time of the frame's pose, or 0 for the newest pose
    shapes: tuple[Shape, ...]
    pose: Rigid = Rigid()  #: of the shapes in the frame
