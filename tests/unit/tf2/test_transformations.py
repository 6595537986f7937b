"""Tests of rotations and matrices under the names of tf_transformations."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from zbot.tf2 import transformations as tf

angles = st.floats(-3, 3)
AXES = [
    frame + "".join(turns)
    for frame in "sr"
    for turns in itertools.product("xyz", repeat=3)
    if turns[0] != turns[1] != turns[2]
]


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


@pytest.mark.parametrize("axes", AXES)
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


@pytest.mark.parametrize("axes", AXES)
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


Q, P = (0.1, -0.2, 0.3, 0.9), (0.5, 0.5, -0.5, 0.5)
MINUS_P = tuple(-part for part in P)
MATRIX = [
    [1.448600287, -1.877613739, -0.895300871, 1.0],
    [0.991040777, 2.063406069, -1.495444217, 2.0],
    [0.958851077, 1.121125347, 3.732570554, 3.0],
]


@pytest.mark.parametrize(
    ("name", "arguments", "kind", "expected"),
    [
        ("quaternion_from_euler", (0.1, -0.2, 0.3), tuple, [0.064071348, -0.091157549, 0.153439302, 0.981856173]),
        ("quaternion_from_euler", (0.1, -0.2, 0.3, "rzyx"), tuple, [0.153439302, -0.091157549, 0.064071348, 0.981856173]),
        ("quaternion_from_euler", (0.1, -0.2, 0.3, "szxz"), tuple, [-0.099334665, -0.009966711, 0.197676812, 0.975170327]),
        ("quaternion_from_euler", (0.1, -0.2, 0.3, (0, 0, 0, 1)), tuple, [0.153439302, -0.091157549, 0.064071348, 0.981856173]),
        ("quaternion_about_axis", (0.7, (1, 2, 3)), tuple, [0.091643294, 0.183286588, 0.274929882, 0.939372713]),
        ("quaternion_multiply", (Q, P), tuple, [0.45, 0.55, -0.15, 0.65]),
        ("quaternion_conjugate", (Q,), np.ndarray, [-0.1, 0.2, -0.3, 0.9]),
        ("quaternion_inverse", (Q,), np.ndarray, [-0.105263158, 0.210526316, -0.315789474, 0.947368421]),
        ("euler_from_quaternion", (Q,), tuple, [0.070471345, -0.45794442, 0.627070663]),
        ("euler_from_quaternion", (Q, "ryxz"), tuple, [-0.339292614, 0.321288589, 0.588002604]),
        ("quaternion_slerp", (Q, P, 0.25), np.ndarray, [0.254943093, -0.010154635, 0.098520544, 0.961870368]),
        ("quaternion_slerp", (Q, MINUS_P, 0.25), np.ndarray, [0.254943093, -0.010154635, 0.098520544, 0.961870368]),
        ("quaternion_slerp", (Q, MINUS_P, 1.0), np.ndarray, MINUS_P),
        ("quaternion_slerp", (Q, MINUS_P, 0.25, 0, False), np.ndarray, [-0.124447754, -0.436663221, 0.540735043, 0.708126825]),
        ("quaternion_slerp", (Q, P, 0.25, 1), np.ndarray, [-0.443198844, -0.505888179, 0.526784624, -0.276027283]),
        ("random_quaternion", ((0.5, 0.25, 0.125),), np.ndarray, [0.707106781, 0.0, 0.5, 0.5]),
        ("vector_norm", ([[3, 4], [6, 8]], 1), np.ndarray, [5.0, 10.0]),
        ("vector_norm", ([[3, 4], [6, 8]],), np.ndarray, [11.180339887]),
        ("unit_vector", ([[3, 4], [6, 8]], 1), np.ndarray, [[0.6, 0.8], [0.6, 0.8]]),
        ("unit_vector", ([[3, 4], [0, 0]],), np.ndarray, [[0.6, 0.8], [0.0, 0.0]]),
    ],
)  # fmt: skip
def test_results_are_those_of_ros_2(
    name: str, arguments: tuple[Any, ...], kind: Any, expected: Any
) -> None:
    result = getattr(tf, name)(*arguments)
    assert isinstance(result, kind)
    assert np.allclose(result, expected, atol=1e-8)
    assert np.shape(result) == np.shape(expected)


def test_a_composed_matrix_is_taken_apart_as_in_ros_2() -> None:
    matrix = tf.compose_matrix((2, 3, 4), (0.1, 0.2, 0.3), (0.4, -0.5, 0.6), (1, 2, 3))
    assert matrix[:3] == pytest.approx(np.array(MATRIX), abs=1e-8)
    assert tf.quaternion_from_matrix(matrix) == pytest.approx(
        (0.255551241, -0.17475706, 0.327581896, 0.892660986)
    )
    assert tf.euler_from_matrix(matrix, "szyx") == pytest.approx(
        (0.913669506, -0.219082562, 0.381064247)
    )


def test_lengths_and_directions_go_into_an_array_of_the_caller() -> None:
    data, lengths = np.array([[3.0, 4.0], [6.0, 8.0]]), np.zeros(2)
    assert tf.vector_norm(data, axis=1, out=lengths) is None
    assert lengths == pytest.approx([5, 10])
    assert tf.unit_vector(data, axis=1, out=data) is None
    assert data == pytest.approx(np.array([[0.6, 0.8], [0.6, 0.8]]))


def test_a_factor_makes_no_other_transform() -> None:
    matrix = tf.translation_matrix((1, 2, 3))
    assert tf.is_same_transform(matrix, matrix * 2)
    assert not tf.is_same_transform(matrix, tf.identity_matrix())


def test_a_random_rotation_keeps_lengths() -> None:
    matrix = tf.random_rotation_matrix()
    assert np.allclose(matrix @ matrix.T, np.identity(4))
    assert np.allclose(
        tf.random_rotation_matrix([0.5, 0.25, 0.0]), tf.random_rotation_matrix([0.5, 0.25, 0.0])
    )
