"""Surfaces that are small on the screen get fewer triangles, and others stay whole."""

from __future__ import annotations

import numpy as np
import pytest

from zbot.view.level_of_detail import centre_and_radius, levels
from zbot.view.shape import Mesh


def test_the_middle_of_a_surface_is_that_of_its_box() -> None:
    vertices = np.array([[10, 0, 2], [12, 4, 2], [11, 2, 0], [11, 2, 4]], np.float32)
    mesh = Mesh(vertices, np.array([[0, 1, 2]], np.uint32))
    centre, radius = centre_and_radius(mesh)
    assert centre == (11, 2, 2)
    assert radius == pytest.approx(5**0.5)


def test_a_large_surface_has_a_level_for_each_distance() -> None:
    found = levels(20_000, 2.0)
    assert [distance for distance, _ in found] == [8, 16, 32, 64]
    assert [part * 20_000 for _, part in found] == pytest.approx([5000, 1500, 500, 150])


@pytest.mark.parametrize(
    ("triangles", "distances"), [(6000, [8, 16, 32]), (1200, [16, 32]), (500, [32]), (200, [])]
)
def test_a_level_that_saves_little_is_left_out(triangles: int, distances: list[float]) -> None:
    assert [distance for distance, _ in levels(triangles, 1.0)] == distances
