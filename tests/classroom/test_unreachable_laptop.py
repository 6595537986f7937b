"""Laptops that get out of reach do not disturb the others."""

from __future__ import annotations

import os
import signal
import time
from typing import TYPE_CHECKING

from tests.classroom.lesson import Lesson, hub_pid
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.testbed import LanTestbed

_HALF_LINKS = 4
# A node starts within a second, also on a busy machine. A thread that closes a link stands still
# for 10 s.
_SEEN_S = 7.0


def test_a_laptop_out_of_reach_does_not_keep_others_out(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(2)
    lesson = Lesson(testbed, 1)
    away, other = testbed.laptops
    pid = hub_pid(testbed.teacher)
    os.kill(pid, signal.SIGSTOP)  # the hub answers only when the laptop is away
    away.start("half_linked.py", testbed.teacher.address, "7447", str(_HALF_LINKS)).wait_for("half")
    away.disconnect()
    os.kill(pid, signal.SIGCONT)
    assert wait_until(lambda: "FIN-WAIT-1" in testbed.teacher.run("ss", "-tn").out)  # it gave up
    joined = other.run("zbot", "join", lesson.code)
    assert joined.code == 0, joined.err


def test_laptops_out_of_reach_do_not_silence_the_others(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(3)
    lesson = Lesson(testbed, 1)
    lesson.join()
    *away, other = testbed.laptops
    for laptop in away:
        laptop.disconnect()
    assert wait_until(lambda: _closed_links(testbed) >= len(away))
    begin = time.monotonic()
    other.start("pupil.py", "late", "late")
    at_s = lesson.watch.until(lambda nodes: (3, "/late") in nodes)
    assert at_s - begin < _SEEN_S


def _closed_links(testbed: LanTestbed) -> int:
    """Return how many links the teacher's hub has closed whose other end does not answer."""
    lines = testbed.teacher.run("ss", "-tn").out.splitlines()
    return sum(line.startswith("FIN-WAIT-1") and ":7447 " in line for line in lines)
