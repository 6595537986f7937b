"""A click means the floor below it, or the nearest object that it meets."""

from __future__ import annotations

import math

import numpy as np
import pytest

from zbot.tf2.rigid import Rigid
from zbot.view import solid
from zbot.view.colors import same
from zbot.view.shape import Axes, Item, Label, Lines, Mesh, Picture, Plane, Points
from zbot.view.tools.pick import distance
from zbot.view.tools.ray import Ray, floor_point

DOWN = Ray((1.0, 2.0, 4.0), (0.0, 0.0, -1.0))


def test_a_ray_meets_the_floor() -> None:
    slope = math.sqrt(0.5)
    assert floor_point(DOWN) == pytest.approx((1, 2, 0))
    assert floor_point(Ray((0, 0, 2), (slope, 0, -slope))) == pytest.approx((2, 0, 0))


@pytest.mark.parametrize("direction", [(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (1.0, 0.0, -1e-6)])
def test_a_ray_to_the_sky_does_not_meet_the_floor(direction: tuple[float, float, float]) -> None:
    assert floor_point(Ray((0, 0, 2), direction)) is None


def test_a_ray_is_seen_from_a_pose() -> None:
    turned = Rigid((1, 0, 0), (0, 0, math.sin(math.pi / 4), math.cos(math.pi / 4)))
    ray = Ray((1, 2, 0), (0, -1, 0)).seen_from(turned)
    assert ray.origin == pytest.approx((2, 0, 0), abs=1e-9)
    assert ray.direction == pytest.approx((-1, 0, 0), abs=1e-9)


def points(*places: tuple[float, float, float]) -> Points:
    return Points(np.array(places, np.float32), same((0, 0, 0), len(places)))


def test_the_nearest_point_in_the_way_is_met() -> None:
    item = Item("a", 0, (points((1, 2, 0), (1, 2.01, 1), (1, 3, 3)),))
    assert distance(DOWN, item) == pytest.approx(3)
    assert distance(DOWN, Item("a", 0, (points((1, 3, 0), (1, 2, 5)),))) is None


def test_a_surface_is_met_inside_of_its_triangles() -> None:
    vertices, faces = solid.box()
    box = Mesh(vertices, faces, pose=Rigid((1.4, 2, 1)))
    assert distance(DOWN, Item("a", 0, (box,))) == pytest.approx(2.5)
    assert distance(DOWN, Item("a", 0, (Mesh(vertices, faces),))) is None


def test_other_shapes_are_met() -> None:
    line = Lines(np.array([[(0, 2, 1), (2, 2, 1)]], np.float32), same((0, 0, 0), 1, 2))
    picture = Plane(np.zeros((1, 1, 3), np.uint8), 2, 2, Rigid((1, 2, 2)))
    axes = Axes((Rigid((1, 2, 3)),))
    found = [
        distance(DOWN, Item("a", 0, (shape,)))
        for shape in (line, picture, axes, Label("a", (1, 2, 1)))
    ]
    assert found == pytest.approx([3, 2, 1, 3], abs=0.1)
    assert distance(DOWN, Item("a", 0, (Picture(b"", "image/png"),))) is None
    aside = Plane(np.zeros((1, 1, 3), np.uint8), 1, 1, Rigid((3, 2, 2)))
    assert distance(DOWN, Item("a", 0, (aside,))) is None
