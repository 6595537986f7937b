"""A lesson: four laptops with three nodes each, and what may happen to them."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

import pytest

from tests.classroom.lesson import Lesson
from tests.classroom.rig import Rig, obstacle

if TYPE_CHECKING:
    from collections.abc import Iterator

LAPTOPS, NODES = 4, 3
IDLE_S = 3.0


@pytest.fixture(scope="module")
def lesson() -> Iterator[Lesson]:
    """A class with everybody's nodes running; every test leaves it like that."""
    reason = obstacle()
    if reason is not None:
        pytest.skip(reason)
    with Rig(LAPTOPS) as rig:
        made = Lesson(rig, NODES)
        made.join()
        made.start_nodes()
        yield made


def test_the_teacher_sees_all_nodes_soon(lesson: Lesson) -> None:
    assert lesson.seen_after_s < 10
    assert len(lesson.watch.nodes) >= LAPTOPS * NODES


def test_a_new_node_is_seen_at_once(lesson: Lesson) -> None:
    laptop = lesson.rig.laptops[-1]
    newcomer = laptop.start("pupil.py", "newcomer", "pupil0")

    seen_s = lesson.watch.until(lambda nodes: (lesson.number_of(laptop), "/newcomer") in nodes)

    made_s = int(newcomer.wait_for("node").split()[1]) / 1e9
    assert seen_s - made_s < 0.5
    newcomer.stop()
    lesson.watch.until(lambda nodes: (lesson.number_of(laptop), "/newcomer") not in nodes)


def test_a_class_that_works_on_its_own_costs_the_teacher_nothing(lesson: Lesson) -> None:
    before = lesson.rig.teacher.traffic()
    # Time has to pass: this measures what flows meanwhile.
    threading.Event().wait(IDLE_S)

    carried = lesson.rig.teacher.traffic() - before

    assert (carried.received_bytes + carried.sent_bytes) / IDLE_S < 5000


@pytest.mark.parametrize(("cut", "mend"), [("unplug", "plug_in"), ("leave_air", "return_to_air")])
def test_a_lost_laptop_is_shown_and_comes_back(lesson: Lesson, cut: str, mend: str) -> None:
    laptop = lesson.rig.laptops[0]
    gone = lesson.nodes_of(laptop)

    cut_s = time.monotonic()
    getattr(laptop, cut)()
    lost_s = lesson.watch.until(lambda nodes: not gone & nodes)
    mended_s = time.monotonic()
    getattr(laptop, mend)()
    back_s = lesson.watch.until(lambda nodes: gone <= nodes)

    assert lost_s - cut_s < 5
    assert back_s - mended_s < 3


def test_a_laptop_that_slept_comes_back(lesson: Lesson) -> None:
    laptop = lesson.rig.laptops[1]
    sleeping = lesson.nodes_of(laptop)

    laptop.sleep()
    lesson.watch.until(lambda nodes: not sleeping & nodes)
    woken_s = time.monotonic()
    laptop.wake_up()
    back_s = lesson.watch.until(lambda nodes: sleeping <= nodes)

    assert back_s - woken_s < 5


def test_a_hub_that_restarts_has_all_back_and_no_laptop_notices(lesson: Lesson) -> None:
    lesson.kill_hub()
    restarted_s = time.monotonic()
    lesson.open_class()
    back_s = lesson.watch.until(lesson.all_there)

    assert back_s - restarted_s < 3
    for heard in lesson.end_nodes():
        assert heard.received > 0
        assert heard.lost == 0
    lesson.start_nodes()
