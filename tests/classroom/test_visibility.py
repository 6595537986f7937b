"""Ways to be invisible in a class, and what says so, on the testbed."""

from __future__ import annotations

import json
import os
import signal
from typing import TYPE_CHECKING, Any

import pytest

from tests.classroom.conftest import skip_without_namespaces
from tests.classroom.lesson import hub_pid
from tests.classroom.test_environment import greeter
from tests.classroom.testbed import LanTestbed
from tests.classroom.watch import Watch
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.classroom.machine import Machine

PIN = {"ZBOT_PIN": "4711"}
ANA = 17


class Lesson:
    """A class of one, in which a node of the student runs."""

    def __init__(self, testbed: LanTestbed, *options: str) -> None:
        self.teacher, (self.ana,) = testbed.teacher, testbed.laptops
        self.options = options
        self.start()
        self.join()
        self.watch = Watch(self.teacher)
        self.node = greeter(self.ana, "work")
        self.watch.until(lambda nodes: (ANA, "/work") in nodes)

    def start(self) -> None:
        assert (
            self.teacher.run("zbot", "class", "start", "Robots", *self.options, env=PIN).code == 0
        )

    def join(self) -> None:
        words = ("join", self.teacher.address, "--number", str(ANA), "--name", "Ana")
        joined = self.ana.run("zbot", *words, env=PIN)
        assert joined.code == 0, joined.err


@pytest.fixture
def lesson() -> Iterator[Lesson]:
    skip_without_namespaces()
    with LanTestbed(1) as testbed:
        yield Lesson(testbed, "--pin")


@pytest.fixture(params=["with a PIN", "without a PIN"])
def lesson_of_each_kind(request: pytest.FixtureRequest) -> Iterator[Lesson]:
    skip_without_namespaces()
    with LanTestbed(1) as testbed:
        yield Lesson(testbed, *(["--pin"] if request.param == "with a PIN" else []))


def failed(machine: Machine) -> str:
    """Return the advice of the checks that fail."""
    done = machine.run("zbot", "doctor", "--json")
    found: list[dict[str, Any]] = json.loads(done.out)
    return "\n".join(check["advice"] for check in found if not check["ok"])


def is_healthy(machine: Machine) -> bool:
    """Wait until no check fails."""
    return wait_until(lambda: failed(machine) == "")


def status(machine: Machine) -> str:
    return machine.run("zbot", "status").out


def test_doctor_compares_membership_nodes_and_hub(lesson: Lesson) -> None:
    assert is_healthy(lesson.ana), failed(lesson.ana)
    assert is_healthy(lesson.teacher), failed(lesson.teacher)
    counts = "1 running, this machine's hub sees 1, and the class sees 1"
    assert wait_until(lambda: counts in lesson.ana.run("zbot", "doctor").out)


def test_a_pulled_cable_is_told_and_ends(lesson: Lesson) -> None:
    lesson.ana.unplug()
    lesson.watch.until(lambda nodes: (ANA, "/work") not in nodes)
    assert wait_until(lambda: "no machine answers" in failed(lesson.ana))
    assert wait_until(lambda: "not linked: no machine answers" in status(lesson.ana))
    lesson.ana.plug_in()
    lesson.watch.until(lambda nodes: (ANA, "/work") in nodes)
    assert is_healthy(lesson.ana), failed(lesson.ana)


def test_after_sleep_the_class_sees_the_nodes_again(lesson: Lesson) -> None:
    lesson.ana.sleep()
    lesson.watch.until(lambda nodes: (ANA, "/work") not in nodes)
    lesson.ana.wake_up()
    lesson.watch.until(lambda nodes: (ANA, "/work") in nodes)
    assert is_healthy(lesson.ana), failed(lesson.ana)


def test_students_read_that_the_class_was_closed(lesson: Lesson) -> None:
    lesson.teacher.run("zbot", "class", "stop")
    assert 'the class "Robots" is closed' in lesson.node.wait_for("the teacher says")
    assert wait_until(lambda: "the teacher has closed the class" in status(lesson.ana))
    assert wait_until(lambda: "the teacher has closed the class" in failed(lesson.ana))


def test_a_laptop_that_slept_while_the_class_closed_is_told_too(lesson: Lesson) -> None:
    lesson.ana.sleep()
    lesson.teacher.run("zbot", "class", "stop")
    lesson.ana.wake_up()
    assert wait_until(lambda: "no class and no hub is open" in status(lesson.ana))


def test_a_class_that_was_started_anew_is_told(lesson_of_each_kind: Lesson) -> None:
    lesson = lesson_of_each_kind
    lesson.teacher.run("zbot", "class", "stop")
    lesson.start()
    assert wait_until(lambda: "the class does not accept this laptop" in failed(lesson.ana))
    assert wait_until(lambda: "does not accept this laptop" in status(lesson.ana))
    lesson.ana.run("zbot", "leave")
    lesson.join()
    again = greeter(lesson.ana, "again")
    Watch(lesson.teacher).until(lambda nodes: (ANA, "/again") in nodes)
    if "--pin" in lesson.options:
        assert wait_until(
            lambda: "/work" in failed(lesson.ana)
        )  # its secret is that of the former class
    lesson.node.stop()
    assert is_healthy(lesson.ana), failed(lesson.ana)
    again.stop()


def test_a_number_that_was_freed_is_told(lesson: Lesson) -> None:
    assert lesson.teacher.run("zbot", "class", "free", str(ANA)).code == 0
    assert wait_until(lambda: "does not accept this laptop" in failed(lesson.ana))


@pytest.mark.parametrize(
    ("number", "sentence"),
    [
        (signal.SIGKILL, "the hub of this machine is not running"),
        (signal.SIGSTOP, "the hub of this machine does not answer"),
    ],
)
def test_a_hub_that_ended_or_hangs_is_told(
    lesson: Lesson, number: signal.Signals, sentence: str
) -> None:
    for machine in (lesson.ana, lesson.teacher):
        os.kill(hub_pid(machine), number)
        assert wait_until(lambda machine=machine: sentence in failed(machine))  # type: ignore[misc]
        assert wait_until(lambda machine=machine: sentence in status(machine))  # type: ignore[misc]


def test_the_new_address_of_the_teacher_is_told(lesson: Lesson) -> None:
    teacher = lesson.teacher
    teacher.run("ip", "addr", "del", f"{teacher.address}/16", "dev", "eth0")
    teacher.run("ip", "addr", "add", "10.77.200.200/16", "dev", "eth0")
    assert wait_until(lambda: "students must join again at 10.77.200.200" in failed(teacher))
    assert wait_until(lambda: "students who have joined must join again" in status(teacher))
    assert wait_until(lambda: "no machine answers" in failed(lesson.ana))


def test_a_teacher_is_told_who_can_end_a_students_node(lesson: Lesson) -> None:
    refused = lesson.teacher.run("zbot", "node", "kill", f"/{ANA}/work")
    assert refused.code == 1
    assert "ask the student to type `zbot node kill /work`" in refused.err
    assert lesson.ana.run("zbot", "node", "kill", "/work").code == 0
