"""Bad Wi-Fi with an interruption: reliable messages arrive or are counted as lost."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import pytest

from tests.classroom.impairment import Impairment, impair
from tests.classroom.lesson import Lesson
from tests.conftest import allowed

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.testbed import LanTestbed
    from tests.conftest import Program

HZ, COUNT = 50, 600
SLOW = Impairment(300, 60, 0)
CALL_TIMEOUT_S = 5.0  # of telemetry.py's calls


def end(program: Program) -> dict[str, Any]:
    """Interrupt a program; return what it says of its work."""
    assert program.stop(timeout=3 * CALL_TIMEOUT_S) == 0
    assert program.lines[-1].startswith("{"), program.output
    report: dict[str, Any] = json.loads(program.lines[-1])
    return report


def test_reliable_messages_arrive_or_are_reported_lost(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(1)
    lesson, laptop = Lesson(testbed, 1), testbed.laptops[0]
    lesson.join()
    impair(testbed, Impairment(delay_ms=20, jitter_ms=10, loss=0.02), [laptop])
    domain = lesson.domain_of(laptop)
    room = testbed.teacher.start("control_room.py", "--last", str(COUNT), env=domain)
    room.wait_for("receiving")
    here = laptop.start(
        *("control_room.py", "--last", str(COUNT), "--ros-args", "-r", "__node:=here"), env=domain
    )
    here.wait_for("receiving")
    telemetry = laptop.start("telemetry.py", "--hz", str(HZ), "--count", str(COUNT), env=domain)
    first = int(room.wait_for("first").split()[1])
    telemetry.wait_for("answered")
    lesson.watch.until(lambda nodes: (1, "/telemetry") in nodes)

    # The teacher's hub closes the link to the laptop, so that all nodes notice the interruption.
    laptop.disconnect()
    lesson.watch.until(lambda nodes: (1, "/telemetry") not in nodes)
    laptop.reconnect()
    lesson.watch.until(lambda nodes: (1, "/telemetry") in nodes)
    room.wait_for("last", 30)
    here.wait_for("last", 30)

    sent, far, near = (end(program) for program in (telemetry, room, here))
    assert near["gaps"] == []
    assert near["received"] == COUNT
    assert len(far["gaps"]) == 1
    assert far["repeated"] == 0
    assert far["received"] + far["told_lost"] == COUNT - first + 1
    outcomes = [outcome for _, outcome in sent["calls"]]
    assert outcomes[0] == outcomes[-1] == "answered"
    assert {"server_gone", "timeout"} & set(outcomes)
    assert max(took_s for took_s, _ in sent["calls"]) < CALL_TIMEOUT_S + allowed(2)


@pytest.mark.parametrize(
    "impairment",
    [SLOW, Impairment(50, 20, 0.1)],
    ids=["packets take 0.3 s", "a tenth of the packets is lost"],
)
def test_a_laptop_joins_over_bad_wifi(
    make_testbed: Callable[[int], LanTestbed], impairment: Impairment
) -> None:
    testbed = make_testbed(1)
    lesson = Lesson(testbed, 1, pin="471100")
    impair(testbed, impairment, testbed.laptops)
    lesson.join()
    lesson.start_nodes()
    status = testbed.laptops[0].run("zbot", "status")
    assert "\nlinked\n" in status.out, status


def test_a_port_that_refuses_is_not_taken_for_a_blocked_one(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(1)
    impair(testbed, SLOW, testbed.laptops)
    refused = testbed.laptops[0].run("zbot", "join", testbed.teacher.address)
    assert "answers, but no class and no hub is open" in refused.err
