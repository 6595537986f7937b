# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import shape_msgs.msg
from zbot.interfaces import Action, Message, Service

class Mesh(Message):
    """shape_msgs/msg/Mesh

    # A surface made of triangles.

    # Each triangle names three corners by their place in vertices.
    MeshTriangle[] triangles

    # The corners, in m.
    geometry_msgs/Point[] vertices
    """
    def __init__(self, *, triangles: Collection[shape_msgs.msg.MeshTriangle] = ..., vertices: Collection[geometry_msgs.msg.Point] = ..., check_fields: bool = ...) -> None: ...
    @property
    def triangles(self) -> list[shape_msgs.msg.MeshTriangle]: ...
    @triangles.setter
    def triangles(self, value: Collection[shape_msgs.msg.MeshTriangle]) -> None: ...
    @property
    def vertices(self) -> list[geometry_msgs.msg.Point]: ...
    @vertices.setter
    def vertices(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...

class MeshTriangle(Message):
    """shape_msgs/msg/MeshTriangle

    # A triangle of a Mesh.

    uint32[3] vertex_indices # places of its corners in Mesh.vertices
    """
    def __init__(self, *, vertex_indices: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def vertex_indices(self) -> NDArray[numpy.uint32]: ...
    @vertex_indices.setter
    def vertex_indices(self, value: Collection[int]) -> None: ...

class Plane(Message):
    """shape_msgs/msg/Plane

    # An endless plane: all points with a*x + b*y + c*z + d = 0.

    float64[4] coef # a, b, c, d
    """
    def __init__(self, *, coef: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def coef(self) -> NDArray[numpy.float64]: ...
    @coef.setter
    def coef(self, value: Collection[float]) -> None: ...

class SolidPrimitive(Message):
    """shape_msgs/msg/SolidPrimitive

    # A simple solid around the origin, described by a few lengths in m.

    uint8 BOX=1
    uint8 SPHERE=2
    uint8 CYLINDER=3
    uint8 CONE=4
    uint8 PRISM=5

    # One of the shapes above.
    uint8 type

    # The lengths; the constants below say which is which.
    float64[<=3] dimensions  # three at most

    # BOX: lengths of the edges along x, y and z.
    uint8 BOX_X=0
    uint8 BOX_Y=1
    uint8 BOX_Z=2

    # SPHERE: the radius.
    uint8 SPHERE_RADIUS=0

    # CYLINDER and CONE: height along z and radius of the base. The tip of a cone is at +z.
    uint8 CYLINDER_HEIGHT=0
    uint8 CYLINDER_RADIUS=1

    uint8 CONE_HEIGHT=0
    uint8 CONE_RADIUS=1

    # PRISM: the height; the polygon, counterclockwise in x and y, is stretched by half of it up and down z.
    uint8 PRISM_HEIGHT=0
    geometry_msgs/Polygon polygon
    """
    BOX: Final = 1
    SPHERE: Final = 2
    CYLINDER: Final = 3
    CONE: Final = 4
    PRISM: Final = 5
    BOX_X: Final = 0
    BOX_Y: Final = 1
    BOX_Z: Final = 2
    SPHERE_RADIUS: Final = 0
    CYLINDER_HEIGHT: Final = 0
    CYLINDER_RADIUS: Final = 1
    CONE_HEIGHT: Final = 0
    CONE_RADIUS: Final = 1
    PRISM_HEIGHT: Final = 0
    def __init__(self, *, type: int = ..., dimensions: Collection[float] = ..., polygon: geometry_msgs.msg.Polygon = ..., check_fields: bool = ...) -> None: ...
    type: int
    @property
    def dimensions(self) -> array[float]: ...
    @dimensions.setter
    def dimensions(self, value: Collection[float]) -> None: ...
    polygon: geometry_msgs.msg.Polygon
