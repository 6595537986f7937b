"""Nodes that run while their machine joins or leaves a class, on the testbed."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from tests.classroom.conftest import skip_without_namespaces
from tests.classroom.test_environment import greeter
from tests.classroom.testbed import LanTestbed
from tests.classroom.watch import Watch
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.classroom.machine import Machine

PIN = {"ZBOT_PIN": "4711"}
START = ("zbot", "class", "start", "Robots", "--pin")


@pytest.fixture
def testbed() -> Iterator[LanTestbed]:
    skip_without_namespaces()
    with LanTestbed(1) as made:
        yield made


def outside(machine: Machine) -> list[str]:
    """Return what doctor says of nodes outside the class."""
    found = json.loads(machine.run("zbot", "doctor", "--json").out)
    return [
        check["advice"] for check in found if check["check"] == "running nodes" and not check["ok"]
    ]


def test_nodes_that_ran_before_the_class_are_named(testbed: LanTestbed) -> None:
    teacher = testbed.teacher
    programs = [greeter(teacher, f"early{k}") for k in range(3)]
    assert outside(teacher) == []
    started = teacher.run(*START, env=PIN)
    assert '3 nodes of this machine run outside class "Robots"' in started.err
    assert f"/early0 (process {programs[0].process.pid}" in started.err
    assert "End them and start them again" in started.err
    # Whatever runs outside does not disturb what runs inside.
    watch = Watch(teacher)
    late = greeter(teacher, "late")
    watch.until(lambda nodes: (0, "/late") in nodes)
    for words in (("node", "list"), ("topic", "list"), ("status",), ("doctor",)):
        done = teacher.run("zbot", *words)
        assert "3 nodes of this machine run outside" in done.out + done.err
        assert done.code == (words == ("doctor",))
    for program in programs:
        program.stop()
    assert outside(teacher) == []
    assert "outside" not in teacher.run("zbot", "node", "list").err
    late.stop()


def test_nodes_that_ran_before_joining_and_before_leaving_are_named(testbed: LanTestbed) -> None:
    (ana,) = testbed.laptops
    testbed.teacher.run(*START, env=PIN)
    before = greeter(ana, "before")
    echo = ana.start("zbot", "topic", "echo", "/chatter")
    echo.wait_for("Hello")
    join = ("zbot", "join", testbed.teacher.address, "--number", "17")
    joined = ana.run(*join, env=PIN)
    assert joined.code == 0
    assert '2 nodes of this machine run outside class "Robots"' in joined.err
    assert "zbot topic echo /chatter" in joined.err or "topic echo /chatter" in joined.err
    echo.stop()
    before.stop()
    assert outside(ana) == []

    during = greeter(ana, "during")
    left = ana.run("zbot", "leave")
    assert "1 node of this machine runs in a class that was left: /during" in left.err
    assert len(outside(ana)) == 1
    ana.run(*join, env=PIN)
    after = greeter(ana, "after")
    watch = Watch(testbed.teacher)
    watch.until(lambda nodes: (17, "/after") in nodes)
    during.stop()
    after.stop()


def test_a_killed_program_is_not_listed(testbed: LanTestbed) -> None:
    teacher = testbed.teacher
    early = greeter(teacher, "early")
    teacher.run(*START, env=PIN)
    assert len(outside(teacher)) == 1
    early.process.kill()
    early.process.wait(5)
    assert wait_until(lambda: outside(teacher) == [])


def test_a_node_in_another_domain_is_named(testbed: LanTestbed) -> None:
    (ana,) = testbed.laptops
    testbed.teacher.run(*START, env=PIN)
    ana.run("zbot", "join", testbed.teacher.address, "--number", "17", env=PIN)
    other = ana.start("zbot", "--domain", "7", "run", "talker")
    other.wait_for("Publishing")
    hidden = greeter(ana, "hidden", ZBOT_DISCOVERY_RANGE="OFF")
    (advice,) = outside(ana)
    assert "/talker" in advice
    assert "it uses domain 7" in advice
    assert "ZBOT_DISCOVERY_RANGE=OFF" in advice
    other.stop()
    hidden.stop()
