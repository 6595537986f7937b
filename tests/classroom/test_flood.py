"""Delay of other students' messages while one student publishes too fast."""

from __future__ import annotations

import statistics
from typing import TYPE_CHECKING

from tests.classroom.lesson import Lesson
from tests.conftest import allowed

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.testbed import LanTestbed

SHARE = 1.2
BEAT = ("--beat", "0.5")
BEATS = 4  # of each kind at least, and at most:
MOST_BEATS = 20
# The flood's rhythm (flood.py): the beat in which it begins or ends is neither.
KINDS = {1: "flood", 3: "quiet"}


def test_a_flood_does_not_delay_what_others_say(make_testbed: Callable[[int], LanTestbed]) -> None:
    """The best beat with it is compared with the usual one without it.

    Whatever else this machine does only adds to a delay; a single quiet beat may be pure luck.
    """
    testbed = make_testbed(2)
    lesson = Lesson(testbed, 1)
    lesson.join()
    flooded, other = testbed.laptops
    teacher = testbed.teacher.start("hear.py", "2/ana/words", "1/flood", *BEAT)
    teacher.wait_for("hearing")
    other.start("pupil.py", "ana", "ana", "--hz", "400").wait_for("hears")
    flooded.start("flood.py", *BEAT).wait_for("flood")

    p99_us: dict[str, list[int]] = {"flood": [], "quiet": []}
    while not is_settled(p99_us):
        _, beat, count, delay_us = teacher.wait_for("beat").split()
        kind = KINDS.get(int(beat) % 4)
        if kind is not None and int(count) > 100:  # a whole one
            p99_us[kind].append(int(delay_us))

    assert is_undelayed(p99_us), p99_us


def is_undelayed(p99_us: dict[str, list[int]]) -> bool:
    return min(p99_us["flood"]) < allowed(SHARE) * statistics.median(p99_us["quiet"])


def is_settled(p99_us: dict[str, list[int]]) -> bool:
    """Return whether the beats suffice, or there will be no more."""
    least = min(map(len, p99_us.values()))
    if least < BEATS:
        return False
    return least >= MOST_BEATS or is_undelayed(p99_us)
