"""Tests of the messages of the panel Drive, and of the words of its browser."""

from __future__ import annotations

import math
from typing import Any

import pytest

from zbot.web.panels.drive.drive_message import SpeedLimits, joy, read_word, twist, velocity

from builtin_interfaces.msg import Time

LIMITS = SpeedLimits(linear_m_s=0.4, angular_rad_s=2.0)


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ([1.0, 0.0, 0.0], (0.4, 0.0, 0.0)),
        ([-0.5, 0.0, 0.25], (-0.2, 0.0, 0.5)),
        ([0.0, 1.0, -1.0], (0.0, 0.4, -2.0)),
        ([0.6, 0.8, 0.0], (0.24, 0.32, 0.0)),
        ([1.0, 1.0, 1.0], (0.4 * math.sqrt(0.5), 0.4 * math.sqrt(0.5), 2.0)),
        ([], (0.0, 0.0, 0.0)),
    ],
)
def test_velocities_are_within_the_limits(values: list[float], expected: tuple[float, ...]) -> None:
    assert velocity(values, LIMITS) == pytest.approx(expected)


def test_a_stamp_makes_a_twist_stamped_in_the_frame_of_the_robot() -> None:
    message = twist((0.1, 0.2, 0.3), Time(sec=5))
    assert (message.header.stamp.sec, message.header.frame_id) == (5, "base_link")
    assert message.twist == twist((0.1, 0.2, 0.3))
    assert (message.twist.linear.x, message.twist.linear.y) == (0.1, 0.2)
    assert message.twist.angular.z == 0.3


def test_the_sticks_are_those_of_common_gamepads() -> None:
    message = joy([1.0, -1.0, 0.5, 0.25, 0.0, 1.0], Time(sec=5))
    assert list(message.axes) == [-1.0, -1.0, -0.5, -0.5, 0.25, 0.25, 0.0, 0.0]
    assert list(message.buttons) == [0, 1] + [0] * 9
    assert (message.header.stamp.sec, message.header.frame_id) == (5, "joy")


def test_limits_that_are_no_speeds_change_nothing() -> None:
    limits = SpeedLimits()
    limits.set(None, "fast")
    limits.set(-1, math.nan)
    assert limits == SpeedLimits()
    limits.set(0, 3)
    assert limits == SpeedLimits(0.0, 3.0)


@pytest.mark.parametrize(
    "arguments",
    [
        *(None, [], [1, 2], [1, 2, [0]], ["a", 1, [0], 0], [1, 1, None, 0], [1, 1, ["x"], 0]),
        *([1, 1, [math.nan], 0], [1, 1, [0], math.inf], [1, 1, [0], None], "abc", 7),
    ],
)
def test_words_of_another_form_are_ignored(arguments: Any) -> None:
    assert read_word(arguments) is None


def test_values_of_a_word_are_from_minus_one_to_one() -> None:
    assert read_word([1, 2, [9, -9, 0.5], 500]) == (1, 2, [1.0, -1.0, 0.5], 0.5)
