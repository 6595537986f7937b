"""Markers of a world for the 3D view: its walls, and its things that move."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.simulation.engine import engine
from zbot.simulation.node.frames import WORLD_FRAME

from geometry_msgs.msg import Point
from visualization_msgs.msg import Marker, MarkerArray

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.simulation.world import World

_MOST = 5000
_MOST_SHOWN = 65  #: rows and columns of hills
_FLOOR_MARGIN_M, _FLOOR_THICKNESS_M = 0.5, 0.02


class WorldMarkers:
    """Markers of all solids of a world that belong to no robot."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._last: Any = None

    def fixed(self) -> Any:
        """Return the markers of what never moves, and of the floor."""
        model = self._world.model
        return self._array(np.flatnonzero(model.body_weldid[model.geom_bodyid] == 0))

    def moving(self) -> Any:
        """Return the markers of things that can move, or None if none has moved since last time."""
        model, data = self._world.model, self._world.data
        # Robots of Gazebo have no description and no frames of their own in the view.
        robots = self._world.robots.values()
        roots = [robot.root for robot in robots if not robot.model.is_gazebo]
        bodies = model.geom_bodyid
        is_free = (model.body_weldid[bodies] != 0) & ~np.isin(model.body_rootid[bodies], roots)
        found = np.flatnonzero(is_free)
        places = data.geom_xpos[found].round(4)
        if self._last is not None and np.array_equal(self._last, places):
            return None
        self._last = places
        return self._array(found)

    def _array(self, geoms: Iterable[Any]) -> Any:
        markers = [Marker(action=Marker.DELETEALL)]
        for geom in geoms:
            marker = self._marker(int(geom))
            if marker is not None:
                markers.append(marker)
        markers[0].header.frame_id = WORLD_FRAME
        return MarkerArray(markers=markers[:_MOST])

    def _marker(self, geom: int) -> Any:
        model, data, kinds = self._world.model, self._world.data, engine().mjtGeom
        kind, size = int(model.geom_type[geom]), model.geom_size[geom]
        marker = Marker(id=geom, ns="world", type=Marker.CUBE, action=Marker.ADD)
        marker.frame_locked = True
        marker.header.frame_id = WORLD_FRAME
        place = data.geom_xpos[geom]
        if kind == kinds.mjGEOM_PLANE:
            place, size = self._floor()
        elif kind in {kinds.mjGEOM_CYLINDER, kinds.mjGEOM_CAPSULE}:
            marker.type = Marker.CYLINDER
            size = (size[0], size[0], size[1])
        elif kind in {kinds.mjGEOM_SPHERE, kinds.mjGEOM_ELLIPSOID}:
            marker.type = Marker.SPHERE
            size = (size[0],) * 3 if kind == kinds.mjGEOM_SPHERE else size
        elif kind == kinds.mjGEOM_MESH:
            marker.type, size = Marker.TRIANGLE_LIST, (0.5, 0.5, 0.5)
            marker.points = self._triangles(int(model.geom_dataid[geom]))
        elif kind == kinds.mjGEOM_HFIELD:
            marker.type, size = Marker.TRIANGLE_LIST, (0.5, 0.5, 0.5)
            marker.points = self._hills(int(model.geom_dataid[geom]))
        elif kind != kinds.mjGEOM_BOX:
            return None
        at, scale, color = marker.pose.position, marker.scale, marker.color
        at.x, at.y, at.z = (float(part) for part in place)
        scale.x, scale.y, scale.z = (2 * float(part) for part in size)
        color.r, color.g, color.b, color.a = model.geom_rgba[geom].tolist()
        quaternion = np.empty(4)
        engine().mju_mat2Quat(quaternion, data.geom_xmat[geom])
        turned = marker.pose.orientation
        turned.w, turned.x, turned.y, turned.z = quaternion.tolist()
        return marker

    def _floor(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Return the middle and half of the size of the part of the floor that is shown."""
        low, high = self._world.bounds()
        middle, half = (low + high) / 2, (high - low) / 2 + _FLOOR_MARGIN_M
        thick = _FLOOR_THICKNESS_M
        return (*middle.tolist(), -thick / 2 - 1e-3), (*half.tolist(), thick / 2)

    def _triangles(self, mesh: int) -> list[Any]:
        model = self._world.model
        first, count = int(model.mesh_faceadr[mesh]), int(model.mesh_facenum[mesh])
        start = int(model.mesh_vertadr[mesh])
        corners = model.mesh_vert[start + model.mesh_face[first : first + count].ravel()]
        return [Point(x=x, y=y, z=z) for x, y, z in corners.tolist()]

    def _hills(self, field: int) -> list[Any]:
        """Return the triangles of a field of heights. A large field has fewer rows and columns."""
        model = self._world.model
        rows, columns = int(model.hfield_nrow[field]), int(model.hfield_ncol[field])
        start = int(model.hfield_adr[field])
        heights = model.hfield_data[start : start + rows * columns].reshape(rows, columns)
        x, y, z, _ = model.hfield_size[field].tolist()
        down, along = (
            np.linspace(0, count - 1, min(count, _MOST_SHOWN)).round().astype(int)
            for count in (rows, columns)
        )
        xs, ys = np.meshgrid(along / (columns - 1) * 2 * x - x, down / (rows - 1) * 2 * y - y)
        grid = np.stack([xs, ys, heights[np.ix_(down, along)] * z], axis=2)
        a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
        corners = np.stack([a, b, c, a, c, d], axis=2).reshape(-1, 3)
        return [Point(x=x, y=y, z=z) for x, y, z in corners.tolist()]
