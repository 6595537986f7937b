"""Errors of `zbot join`: each has a message of its own and appears within four seconds."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.classroom.conftest import skip_without_namespaces
from tests.classroom.lesson import Lesson
from tests.classroom.testbed import LanTestbed
from tests.conftest import allowed, wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.classroom.machine import Machine

LIMIT_S = 4.0
PIN = "4711"


@pytest.fixture(scope="module")
def lesson() -> Iterator[Lesson]:
    """An open class of two laptops, which have not joined yet."""
    skip_without_namespaces()
    with LanTestbed(2) as testbed:
        yield Lesson(testbed, 1, pin=PIN)


def has_no_processes(laptop: Machine) -> bool:
    """Return whether no process runs on a laptop, after a short wait for a hub that ends."""
    return wait_until(lambda: not laptop.processes())


def join_error(lesson: Lesson, *words: str, pin: str = PIN) -> str:
    """Return the sentence with which `zbot join` fails, in time and without joining."""
    laptop = lesson.testbed.laptops[0]
    took_s: list[float] = []
    while True:
        refused = laptop.run("zbot", "join", *words, env={"ZBOT_PIN": pin})
        assert refused.code == 1
        assert refused.out == ""
        assert len(refused.err.splitlines()) == 1
        assert has_no_processes(laptop)
        took_s.append(refused.took_s)
        if len(took_s) == 4 or refused.took_s < LIMIT_S:  # one idle moment is enough
            break
    assert min(took_s) < allowed(LIMIT_S)
    assert "joined nothing" in laptop.run("zbot", "status").out
    return refused.err.strip()


def test_a_mistyped_code(lesson: Lesson) -> None:
    last = lesson.code[-1]
    typo = lesson.code[:-1] + ("2" if last != "2" else "3")

    assert f"the code '{typo}' has a typo" in join_error(lesson, typo)


def test_a_wrong_pin(lesson: Lesson) -> None:
    assert "wrong PIN" in join_error(lesson, lesson.code, pin="4712")


def test_no_pin(lesson: Lesson) -> None:
    assert "the class requires a PIN" in join_error(lesson, lesson.code, pin="")


def test_an_unreachable_teacher(lesson: Lesson) -> None:
    assert "no machine answers at 10.77.200.1:7447" in join_error(lesson, "10.77.200.1")


def test_a_teacher_without_a_class(lesson: Lesson) -> None:
    sentence = join_error(lesson, f"{lesson.testbed.teacher.address}:7448")

    assert "10.77.0.1 answers, but no class" in sentence
    assert "zbot class start" in sentence


def test_a_blocked_port(lesson: Lesson) -> None:
    laptop = lesson.testbed.laptops[0]
    laptop.block_port(7447)
    try:
        sentence = join_error(lesson, lesson.code)
    finally:
        laptop.unblock_ports()

    assert "10.77.0.1 answers, but its port 7447 is blocked" in sentence
    assert "firewall" in sentence


def test_a_laptop_without_a_network(lesson: Lesson) -> None:
    laptop = lesson.testbed.laptops[0]
    laptop.unplug()
    try:
        sentence = join_error(lesson, lesson.testbed.teacher.address)
    finally:
        laptop.plug_in()

    assert "no machine answers at 10.77.0.1:7447" in sentence


WEB = """
import socket
server = socket.create_server(("0.0.0.0", 80))
print("web", flush=True)
while True:
    connection, _ = server.accept()
    connection.recv(100)
    connection.close()
"""


def test_a_port_of_another_program(lesson: Lesson) -> None:
    lesson.testbed.teacher.start("python", "-c", WEB).wait_for("")

    assert "is not a zbot hub" in join_error(lesson, f"{lesson.testbed.teacher.address}:80")


def test_the_code_and_the_address_both_work(lesson: Lesson) -> None:
    for laptop, target in zip(
        lesson.testbed.laptops, (lesson.code.lower(), lesson.testbed.teacher.address), strict=True
    ):
        joined = laptop.run("zbot", "join", target, env={"ZBOT_PIN": PIN})
        assert joined.code == 0, joined.err
        assert joined.took_s < allowed(6)
        left = laptop.run("zbot", "leave")
        assert left.code == 0, left.err
        assert has_no_processes(laptop)
