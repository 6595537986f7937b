"""Tests of affine matrices: composition, decomposition and the arcball."""

from __future__ import annotations

import importlib
import math
import sys
from typing import Any

import numpy as np
import pytest

import zbot.compat  # noqa: F401 - makes tf_transformations importable
from zbot.tf2 import affine
from zbot.tf2.arcball import (
    Arcball,
    arcball_constrain_to_axis,
    arcball_map_to_sphere,
    arcball_nearest_axis,
)
from zbot.tf2.transformations import (
    compose_matrix,
    concatenate_matrices,
    identity_matrix,
    is_same_transform,
    random_rotation_matrix,
    rotation_matrix,
    scale_matrix,
    translation_matrix,
)

POINT, NORMAL, AXIS = [0.2, -0.4, 1.5], [1.0, 2.0, -0.5], [0.3, 1.0, -2.0]
NAMES = """
identity_matrix translation_matrix translation_from_matrix reflection_matrix
reflection_from_matrix rotation_matrix rotation_from_matrix scale_matrix scale_from_matrix
projection_matrix projection_from_matrix clip_matrix shear_matrix shear_from_matrix
decompose_matrix compose_matrix orthogonalization_matrix superimposition_matrix euler_matrix
euler_from_matrix euler_from_quaternion quaternion_from_euler quaternion_about_axis
quaternion_matrix quaternion_from_matrix quaternion_multiply quaternion_conjugate
quaternion_inverse quaternion_slerp random_quaternion random_rotation_matrix Arcball
arcball_map_to_sphere arcball_constrain_to_axis arcball_nearest_axis vector_norm unit_vector
random_vector inverse_matrix concatenate_matrices is_same_transform TRANSLATION_IDENTITY
ROTATION_IDENTITY ZOOM_IDENTITY SHEAR_IDENTITY
"""


def test_every_name_of_the_package_exists() -> None:
    package = importlib.import_module("tf_transformations")
    assert [name for name in NAMES.split() if not hasattr(package, name)] == []


def test_a_mirror_swaps_both_sides_of_its_plane() -> None:
    mirror = affine.reflection_matrix(POINT, NORMAL)
    assert np.allclose(mirror @ [*POINT, 1], [*POINT, 1])
    assert np.allclose(mirror @ [*NORMAL, 0], [-1.0, -2.0, 0.5, 0])
    assert is_same_transform(
        mirror, affine.reflection_matrix(*affine.reflection_from_matrix(mirror))
    )


def test_a_rotation_is_recovered_from_its_matrix() -> None:
    turn = rotation_matrix(0.7, AXIS, POINT)
    angle, axis, point = affine.rotation_from_matrix(turn)
    assert abs(angle) == pytest.approx(0.7)  # the axis may have either direction
    assert is_same_transform(turn, rotation_matrix(angle, axis, point))
    half = rotation_matrix(math.pi, AXIS, POINT)
    assert is_same_transform(half, rotation_matrix(*affine.rotation_from_matrix(half)))
    assert affine.rotation_from_matrix(identity_matrix())[0] == 0


@pytest.mark.parametrize("direction", [None, AXIS])
@pytest.mark.parametrize("factor", [-1.234, 0.5, 3.0])
def test_a_scale_is_recovered_from_its_matrix(factor: float, direction: list[float] | None) -> None:
    scale = scale_matrix(factor, POINT, direction)
    found = affine.scale_from_matrix(scale)
    assert found[0] == pytest.approx(factor)
    assert is_same_transform(scale, scale_matrix(*found))


def test_a_shear_is_recovered_from_its_matrix() -> None:
    along = np.cross(NORMAL, AXIS)
    shear = affine.shear_matrix(0.4, along, POINT, NORMAL)
    assert np.allclose(shear @ [*POINT, 1], [*POINT, 1])
    assert affine.shear_from_matrix(shear)[0] == pytest.approx(0.4)
    assert is_same_transform(shear, affine.shear_matrix(*affine.shear_from_matrix(shear)))
    with pytest.raises(ValueError, match="right angles"):
        affine.shear_matrix(0.4, NORMAL, POINT, NORMAL)


@pytest.mark.parametrize(
    ("direction", "perspective", "pseudo"),
    [(None, None, False), (AXIS, None, False), (None, AXIS, False), (None, AXIS, True)],
)
def test_a_projection_is_recovered_from_its_matrix(
    direction: list[float] | None, perspective: list[float] | None, *, pseudo: bool
) -> None:
    flat = affine.projection_matrix(POINT, NORMAL, direction, perspective, pseudo)
    found = affine.projection_from_matrix(flat, pseudo)
    assert is_same_transform(flat, affine.projection_matrix(*found))
    if not pseudo:
        image = flat @ [3.0, -1.0, 0.5, 1.0]
        onto = (image / image[3])[:3] - POINT
        assert onto @ np.array(NORMAL) == pytest.approx(0, abs=1e-9)


def test_a_matrix_of_another_kind_is_refused() -> None:
    moved = translation_matrix([1, 2, 3])
    for function in (
        affine.reflection_from_matrix,
        affine.scale_from_matrix,
        affine.shear_from_matrix,
    ):
        with pytest.raises(ValueError, match="the matrix is not a"):
            function(moved)
    with pytest.raises(ValueError, match="not a rotation"):
        affine.rotation_from_matrix(scale_matrix(2))
    with pytest.raises(ValueError, match="not a rotation"):
        affine.rotation_from_matrix(moved)
    with pytest.raises(ValueError, match="not a shear"):
        affine.shear_from_matrix(scale_matrix(2))
    with pytest.raises(ValueError, match="not a projection"):
        affine.projection_from_matrix(moved)


@pytest.mark.parametrize("perspective", [False, True])
def test_a_box_becomes_the_unit_cube(*, perspective: bool) -> None:
    clip = affine.clip_matrix(-1, 2, -3, 1, 1, 5, perspective)
    near_corner = clip @ [-1, -3, 1, 1]
    assert np.allclose(near_corner / near_corner[3], [-1, -1, -1, 1])
    far_corner = clip @ ([10, 5, 5, 1] if perspective else [2, 1, 5, 1])
    assert np.allclose(far_corner / far_corner[3], [1, 1, 1, 1])
    with pytest.raises(ValueError, match="left < right"):
        affine.clip_matrix(2, -1, -3, 1, 1, 5)


def test_a_crystal_s_edges_get_their_lengths_and_angles() -> None:
    assert np.allclose(
        affine.orthogonalization_matrix((10, 10, 10), (90, 90, 90))[:3, :3], np.identity(3) * 10
    )
    edges = affine.orthogonalization_matrix([9.8, 12.0, 15.5], [87.2, 80.7, 69.7])[:3, :3].T
    assert np.allclose(np.linalg.norm(edges, axis=1), [9.8, 12.0, 15.5])
    cosine = edges[1] @ edges[2] / 12.0 / 15.5
    assert math.degrees(math.acos(cosine)) == pytest.approx(87.2)
    cosine = edges[0] @ edges[1] / 9.8 / 12.0
    assert math.degrees(math.acos(cosine)) == pytest.approx(69.7)


@pytest.mark.parametrize("scaling", [False, True])
def test_points_are_superimposed_on_points(*, scaling: bool) -> None:
    points = affine.random_vector(30).reshape(3, 10)
    size = scale_matrix(2.5 if scaling else 1.0)
    moved = concatenate_matrices(translation_matrix(POINT), random_rotation_matrix(), size)
    goal = moved[:3, :3] @ points + moved[:3, 3:]
    assert is_same_transform(moved, affine.superimposition_matrix(points, goal, scaling))


def test_two_sets_of_points_have_the_same_size() -> None:
    with pytest.raises(ValueError, match="same number of points"):
        affine.superimposition_matrix(np.zeros((3, 4)), np.zeros((3, 5)))


@pytest.mark.parametrize("library", ["numpy", "transforms3d"])
def test_a_missing_library_is_named(monkeypatch: pytest.MonkeyPatch, library: str) -> None:
    package = "tf_transformations"
    names = [name for name in sys.modules if name.startswith(("zbot.tf2.", package))]
    for name in names:
        if name.endswith((package, ".affine", ".arcball", ".transformations")):
            monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(ImportError, match=rf'needs {library}: .* -m pip install "zbot\[numpy\]"'):
        importlib.import_module(package)


@pytest.mark.parametrize(
    ("name", "arguments", "expected"),
    [
        ("rotation_matrix", (0.7, (1, 2, 3), (4, 5, 6)), [[0.781639174, -0.482929284, 0.394739798, 0.919650936], [0.550117231, 0.832030134, -0.071392499, -0.932264595], [-0.293957878, 0.272956339, 0.916015067, 0.314959418], [0, 0, 0, 1]]),
        ("scale_matrix", (-1.5, (1, 2, 3), (0, 1, 1)), [[1, 0, 0, 0], [0, -0.25, -1.25, 6.25], [0, -1.25, -0.25, 6.25], [0, 0, 0, 1]]),
        ("reflection_matrix", ((1, 2, 3, 1), (1, 0, 2)), [[0.6, 0, -0.8, 2.8], [0, 1, 0, 0], [-0.8, 0, -0.6, 5.6], [0, 0, 0, 1]]),
        ("shear_matrix", (0.3, (0, 2, 0), (1, 2, 3), (1, 0, 0)), [[1, 0, 0, 0], [0.30933625, 1, 0, -0.30933625], [0, 0, 1, 0], [0, 0, 0, 1]]),
        ("projection_matrix", ((1, 2, 3), (1, 0, 2), (0, 1, 1)), [[1, 0, 0, 0], [-0.5, 1, -1, 3.5], [-0.5, 0, 0, 3.5], [0, 0, 0, 1]]),
        ("projection_matrix", ((1, 2, 3), (1, 0, 2), None, (5, 5, 5), True), [[1.141640786, 0, -4.872135955, 17.052475842], [-2.236067977, 3.577708764, -4.472135955, 15.652475842], [-2.636067977, 0, -1.694427191, 18.452475842], [-0.447213595, 0, -0.894427191, 6.708203932]]),
        ("clip_matrix", (-1, 2, -3, 1, 1, 5, True), [[-0.666666667, 0, 0.333333333, 0], [0, -0.5, -0.5, 0], [0, 0, -1.5, 2.5], [0, 0, -1, 0]]),
        ("orthogonalization_matrix", ((1, 2, 3), (80, 70, 60)), [[0.82634748, 0, 0, 0], [0.447405927, 1.969615506, 0, 0], [0.342020143, 0.347296355, 3, 0], [0, 0, 0, 1]]),
        ("arcball_map_to_sphere", ([30, 40], [10, 20], 100), [0.2, -0.2, 0.959166305]),
        ("arcball_constrain_to_axis", ([0.6, 0, -0.8], [0, 1, 0]), [-0.6, 0, 0.8]),
    ],
)  # fmt: skip
def test_results_are_those_of_ros_2(name: str, arguments: tuple[Any, ...], expected: Any) -> None:
    function = getattr(importlib.import_module("tf_transformations"), name)
    assert np.allclose(function(*arguments), expected, atol=1e-8)


def test_the_ball_follows_the_pointer() -> None:
    ball = Arcball()
    ball.place([320, 320], 320)
    ball.down([320, 320])
    ball.drag([320, 160])
    # The point in front has moved up by half a radius.
    assert np.allclose(ball.matrix()[:3, 2], rotation_matrix(-2 * math.pi / 6, [1, 0, 0])[:3, 2])
    before = ball.matrix()
    ball.next()
    assert is_same_transform(ball.matrix(), before @ before)


def test_a_constrained_ball_turns_about_one_axis() -> None:
    ball = Arcball(compose_matrix())
    ball.place([0, 0], 100)
    ball.setaxes([0, 0, 1], [0, 1, 0])
    ball.setconstrain(True)
    assert ball.getconstrain()
    ball.down([10, 0])
    ball.drag([60, 20])
    assert np.allclose(ball.matrix()[:3, 1], [0, 1, 0])


def test_points_are_mapped_to_the_sphere() -> None:
    assert np.allclose(arcball_map_to_sphere([3, 0], [0, 0], 2), [1, 0, 0])
    assert np.allclose(arcball_map_to_sphere([0, 0], [0, 0], 2), [0, 0, 1])
    assert np.allclose(arcball_constrain_to_axis([1, 0, 0], [0, 0, 1]), [1, 0, 0])
    assert np.allclose(arcball_constrain_to_axis([0, 1, 0], [0, 1, 0]), [-1, 0, 0])
    assert arcball_nearest_axis([1, 0, 0], [[1, 0, 0], [0, 0, 1]]) == [0, 0, 1]
