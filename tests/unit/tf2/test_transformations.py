"""Tests of rotations and matrices under the names of tf_transformations."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from zbot.tf2 import transformations as tf

angles = st.floats(-3, 3)


def test_known_rotations_have_known_quaternions() -> None:
    assert tf.quaternion_from_euler(0, 0, math.pi / 2) == pytest.approx(
        [0, 0, math.sqrt(0.5), math.sqrt(0.5)]
    )
    assert tf.quaternion_from_euler(1, 2, 3, "ryxz") == pytest.approx(
        [0.310622, -0.718287, 0.444435, 0.435953], abs=1e-6
    )
    assert tf.euler_from_quaternion([0.06146124, 0, 0, 0.99810947]) == pytest.approx(
        (0.123, 0, 0), abs=1e-6
    )


@given(angles, st.floats(-1.5, 1.5), angles)
def test_roll_pitch_and_yaw_are_recovered(roll: float, pitch: float, yaw: float) -> None:
    assert tf.euler_from_quaternion(tf.quaternion_from_euler(roll, pitch, yaw)) == pytest.approx(
        (roll, pitch, yaw), abs=1e-6
    )


@pytest.mark.parametrize("axes", sorted(tf._AXES))
@given(angles, angles, angles)
def test_every_order_of_axes_gives_the_same_rotation_again(
    axes: str, a: float, b: float, c: float
) -> None:
    matrix = tf.euler_matrix(a, b, c, axes)
    again = tf.euler_matrix(*tf.euler_from_matrix(matrix, axes), axes)
    assert np.allclose(matrix, again, atol=1e-5)
    assert tf.is_same_transform(tf.quaternion_matrix(tf.quaternion_from_matrix(matrix)), matrix)


def test_a_product_with_the_inverse_is_the_identity() -> None:
    q = tf.quaternion_about_axis(0.7, (1, 2, 3))
    assert tf.quaternion_multiply(q, tf.quaternion_inverse(q)) == pytest.approx([0, 0, 0, 1])
    turned = tf.rotation_matrix(0.7, (1, 2, 3), (4, 5, 6)) @ [4, 5, 6, 1]
    assert turned == pytest.approx([4, 5, 6, 1])
    moved = tf.concatenate_matrices(tf.translation_matrix((1, 0, 0)), tf.scale_matrix(2))
    assert moved @ [1, 1, 1, 1] == pytest.approx([3, 2, 2, 1])
    assert tf.inverse_matrix(moved) @ moved == pytest.approx(tf.identity_matrix())
    composed = tf.compose_matrix(scale=(2, 2, 2), angles=(0, 0, math.pi / 2), translate=(1, 0, 0))
    assert composed @ [1, 0, 0, 1] == pytest.approx([1, 2, 0, 1])
    assert tf.translation_from_matrix(composed) == pytest.approx([1, 0, 0])


def test_a_composed_matrix_may_shear_and_project() -> None:
    slanted = tf.compose_matrix((1, 1, 1), (0.5, 0, 0), (0, 0, 0), (1, 0, 0))
    assert slanted @ [0, 2, 0, 1] == pytest.approx([2, 2, 0, 1])
    projected = tf.compose_matrix(perspective=(0, 0, 1, 2))
    assert projected[3] == pytest.approx([0, 0, 0.5, 1])


TURNS = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


@pytest.mark.parametrize("axes", sorted(tf._AXES))
def test_every_order_of_axes_is_a_product_of_turns(axes: str) -> None:
    angles = (0.3, -0.7, 1.1)
    turns = [
        tf.rotation_matrix(angle, TURNS[axis]) for angle, axis in zip(angles, axes[1:], strict=True)
    ]
    # Fixed axes: the first rotation is applied first. Axes of the body: it is the first factor.
    product = tf.concatenate_matrices(*(turns if axes[0] == "r" else reversed(turns)))
    assert tf.euler_matrix(*angles, axes) == pytest.approx(product)


def test_quaternions_are_multiplied_by_hamiltons_rule() -> None:
    assert tf.quaternion_multiply([1, 0, 0, 0], [0, 1, 0, 0]) == pytest.approx([0, 0, 1, 0])
    assert tf.quaternion_multiply([0, 1, 0, 0], [1, 0, 0, 0]) == pytest.approx([0, 0, -1, 0])


@pytest.mark.parametrize("q", [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0.5, -0.5, 0.5, 0.5]])
def test_large_rotations_are_recovered_from_their_matrix(q: list[float]) -> None:
    again = tf.quaternion_from_matrix(tf.quaternion_matrix(q))
    assert abs(float(np.dot(again, q))) == pytest.approx(1)


def test_slerp_gives_the_rotation_between_two_others() -> None:
    a, b = tf.quaternion_from_euler(0, 0, 0), tf.quaternion_from_euler(0, 0, 1)
    half = tf.quaternion_slerp(a, b, 0.5)
    assert tf.euler_from_quaternion(half) == pytest.approx((0, 0, 0.5))
    assert tf.quaternion_slerp(a, b, 0.0) == pytest.approx(a)
    assert tf.quaternion_slerp(a, b, 1.0) == pytest.approx(b)


def test_vector_lengths_are_computed() -> None:
    assert tf.vector_norm([3, 4]) == 5
    assert tf.unit_vector([0, 0, 2]) == pytest.approx([0, 0, 1])
    assert tf.vector_norm(tf.random_quaternion()) == pytest.approx(1)


def test_invalid_axes_are_refused() -> None:
    with pytest.raises(KeyError, match="sxyz"):
        tf.euler_matrix(1, 2, 3, "abc")


positive = st.floats(0.2, 5)


@given(st.tuples(positive, positive, positive), st.tuples(angles, st.floats(-1.5, 1.5), angles))
def test_a_matrix_is_decomposed_into_its_parts(
    scale: tuple[float, float, float], turn: tuple[float, float, float]
) -> None:
    parts = (scale, [0.1, -0.2, 0.3], turn, (1.0, -2.0, 3.0), (0.0, 0.0, 0.0, 1.0))
    found: tuple[Any, ...] = tf.decompose_matrix(tf.compose_matrix(*parts) * 2)
    for part, expected in zip(found, parts, strict=True):
        assert np.allclose(part, expected, atol=1e-6)


@pytest.mark.parametrize(
    "matrix",
    [
        np.diag([-1.0, 2.0, 3.0, 1.0]),
        tf.compose_matrix(translate=(1, 2, 3), perspective=(0.1, 0.2, 0.0, 1)),
    ],
)
def test_mirrors_and_projections_are_decomposed(matrix: tf.Matrix) -> None:
    assert np.allclose(tf.compose_matrix(*tf.decompose_matrix(matrix)), matrix)


@pytest.mark.parametrize("matrix", [np.zeros((4, 4)), np.diag([1, 1, 0, 1]), np.diag([1, 1, 1, 0])])
def test_a_singular_matrix_cannot_be_decomposed(matrix: tf.Matrix) -> None:
    with pytest.raises(ValueError, match="singular"):
        tf.decompose_matrix(matrix)


def test_a_random_rotation_keeps_lengths() -> None:
    matrix = tf.random_rotation_matrix()
    assert np.allclose(matrix @ matrix.T, np.identity(4))
    assert np.allclose(
        tf.random_rotation_matrix([0.5, 0.25, 0.0]), tf.random_rotation_matrix([0.5, 0.25, 0.0])
    )
