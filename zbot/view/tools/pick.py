"""Search for the object that a click means."""

from __future__ import annotations

from functools import singledispatch
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view.shape import Arrows, Axes, Copies, Label, Lines, Mesh, Plane, Points
from zbot.view.tools.ray import (
    Ray,
    distance_to_lines,
    distance_to_points,
    distance_to_surface,
    floor_point,
)

if TYPE_CHECKING:
    from zbot.view.shape import Item

#: Radius of what a click means, as a share of the distance: about 10 pixels.
_WIDTH = 0.015


def distance(ray: Ray, item: Item) -> float | None:
    """Return the distance to the nearest shape of an item that a ray meets, or None.

    Args:
        ray: The ray in the coordinates of the item's shapes.
        item: The item.
    """
    found = (shape_distance(shape, ray) for shape in item.shapes)
    return min((one for one in found if one is not None), default=None)


@singledispatch
def shape_distance(_shape: Any, _ray: Ray) -> float | None:
    """Return the distance to a shape that a ray meets, or None."""
    return None


@shape_distance.register
def _(shape: Points, ray: Ray) -> float | None:
    return distance_to_points(ray, shape.positions, _WIDTH)


@shape_distance.register
def _(shape: Copies, ray: Ray) -> float | None:
    return distance_to_points(ray, shape.positions, 2 * _WIDTH)


@shape_distance.register
def _(shape: Lines, ray: Ray) -> float | None:
    return distance_to_lines(ray, shape.ends, _WIDTH)


@shape_distance.register
def _(shape: Arrows, ray: Ray) -> float | None:
    return distance_to_lines(ray, shape.ends, _WIDTH)


@shape_distance.register
def _(shape: Axes, ray: Ray) -> float | None:
    places = np.array([pose.translation for pose in shape.poses], np.float32).reshape(-1, 3)
    return distance_to_points(ray, places, 2 * _WIDTH)


@shape_distance.register
def _(shape: Label, ray: Ray) -> float | None:
    return distance_to_points(ray, np.array([shape.position], np.float32), 2 * _WIDTH)


@shape_distance.register
def _(shape: Mesh, ray: Ray) -> float | None:
    return distance_to_surface(ray.seen_from(shape.pose), shape.vertices, shape.faces)


@shape_distance.register
def _(shape: Plane, ray: Ray) -> float | None:
    own = ray.seen_from(shape.pose)
    place = floor_point(own)
    if place is None or abs(place[0]) > shape.width / 2 or abs(place[1]) > shape.height / 2:
        return None
    return float(np.linalg.norm(np.array(place) - np.array(own.origin)))
