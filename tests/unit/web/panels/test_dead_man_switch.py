"""Tests of the dead man's switch, with a clock that the test moves."""

from __future__ import annotations

import queue

import pytest

from zbot.web.panels.drive.dead_man_switch import SILENCE_S, DeadManSwitch

AHEAD = [1.0, 0.0, -0.5]
ZERO = [0.0, 0.0, 0.0]


class Robot:
    """Clock, browser, and the values that were sent."""

    def __init__(self) -> None:
        self.now_s = 0.0
        self.sent: list[list[float]] = []
        self.switch = DeadManSwitch(
            lambda values: self.sent.append([*values]), lambda: self.now_s, lambda _run: None
        )

    def hear(self, press: int, values: list[float], delay_s: float = 0.0) -> bool:
        """Give a word to the switch that has been under way for some time."""
        return self.switch.hear(press, values, self.now_s - delay_s + 1000)

    def wait(self, seconds: float) -> None:
        self.now_s += seconds
        self.switch.check()

    @property
    def is_watched(self) -> bool:
        return self.switch.check() is not None


@pytest.fixture
def robot() -> Robot:
    return Robot()


def test_values_are_sent_while_the_browser_repeats_them(robot: Robot) -> None:
    for _ in range(40):
        assert robot.hear(1, AHEAD)
        robot.wait(0.05)
    assert robot.sent == [AHEAD] * 40


def test_the_end_of_a_press_sends_one_zero(robot: Robot) -> None:
    robot.hear(1, AHEAD)
    assert robot.hear(1, ZERO)
    robot.wait(10)
    assert robot.sent == [AHEAD, ZERO]
    assert not robot.is_watched


def test_a_silent_browser_sends_one_zero_and_then_nothing(robot: Robot) -> None:
    robot.hear(1, AHEAD)
    robot.wait(SILENCE_S - 0.01)
    assert robot.sent == [AHEAD]
    robot.wait(0.01)
    assert robot.sent == [AHEAD, ZERO]
    robot.wait(10)
    assert robot.sent == [AHEAD, ZERO]
    assert not robot.is_watched


def test_values_that_arrive_late_do_not_move_the_robot(robot: Robot) -> None:
    robot.hear(3, AHEAD)
    robot.wait(1)
    assert not robot.hear(3, AHEAD)
    assert not robot.hear(2, AHEAD)
    assert robot.sent == [AHEAD, ZERO]


def test_the_next_press_drives_again(robot: Robot) -> None:
    robot.hear(1, AHEAD)
    robot.wait(1)
    assert robot.hear(2, AHEAD)
    assert robot.sent == [AHEAD, ZERO, AHEAD]
    robot.wait(1)
    assert robot.sent[3:] == [ZERO]


def test_a_stop_sends_one_zero_and_only_to_a_robot_that_drives(robot: Robot) -> None:
    robot.switch.stop()
    assert not robot.sent
    robot.hear(1, AHEAD)
    robot.switch.stop()
    robot.switch.stop()
    assert robot.sent == [AHEAD, ZERO]
    assert not robot.hear(1, AHEAD)
    assert not any(robot.switch.values)


def test_the_silence_begins_when_the_last_word_was_said(robot: Robot) -> None:
    robot.hear(1, AHEAD)
    robot.wait(0.15)
    assert robot.hear(1, AHEAD, delay_s=0.1)
    robot.wait(SILENCE_S - 0.1 - 0.01)
    assert robot.sent == [AHEAD, AHEAD]
    robot.wait(0.01)
    assert robot.sent == [AHEAD, AHEAD, ZERO]


def test_a_word_that_was_under_way_for_too_long_stops_the_robot(robot: Robot) -> None:
    robot.hear(1, AHEAD)
    robot.now_s += SILENCE_S  # nobody checked
    assert not robot.hear(1, AHEAD, delay_s=SILENCE_S)
    assert robot.sent == [AHEAD, ZERO]


def test_a_first_word_that_was_slow_makes_no_later_word_early(robot: Robot) -> None:
    robot.hear(1, AHEAD, delay_s=0.15)
    for _ in range(10):
        robot.wait(0.05)
        assert robot.hear(1, AHEAD)
    robot.wait(SILENCE_S)
    assert robot.sent[-1] == ZERO


def test_a_thread_stops_the_robot() -> None:
    sent: queue.SimpleQueue[list[float]] = queue.SimpleQueue()
    switch = DeadManSwitch(lambda values: sent.put([*values]))
    assert switch.hear(1, AHEAD, 0.0)
    assert [sent.get(timeout=10) for _ in range(2)] == [AHEAD, ZERO]
    assert switch.hear(2, AHEAD, 0.0)
    assert [sent.get(timeout=10) for _ in range(2)] == [AHEAD, ZERO]
