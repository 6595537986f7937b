"""What the environment says against what the machine has joined, on the testbed."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from tests.classroom.conftest import skip_without_namespaces
from tests.classroom.testbed import LanTestbed
from tests.classroom.watch import Watch

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.classroom.machine import Machine
    from tests.conftest import Program

ANA = 17
PIN = {"ZBOT_PIN": "4711"}
IGNORED = (
    'this laptop has number 17 in class "Robots"; '
    "ROS_DOMAIN_ID=7 is ignored; `zbot leave` to use it"
)
ELSEWHERE = '{ mode: "client", connect: { endpoints: ["tcp/10.77.99.99:7447"] } }'


class Lesson:
    """A class of one with a PIN."""

    def __init__(self, testbed: LanTestbed) -> None:
        self.teacher, (self.ana,) = testbed.teacher, testbed.laptops
        assert self.teacher.run("zbot", "class", "start", "Robots", "--pin", env=PIN).code == 0
        words = ("zbot", "join", self.teacher.address, "--number", str(ANA), "--name", "Ana")
        # The hub of this laptop is not on the usual port, and later terminals do not know that.
        assert self.ana.run(*words, env={**PIN, "ZBOT_HUB_PORT": "7460"}).code == 0
        self.watch = Watch(self.teacher)


@pytest.fixture(scope="module")
def lesson() -> Iterator[Lesson]:
    skip_without_namespaces()
    with LanTestbed(1) as testbed:
        yield Lesson(testbed)


def greeter(machine: Machine, name: str, *command: str, **env: str) -> Program:
    """Start a greeter, and return it when it talks."""
    words = (*command, "greeter.py", "--ros-args", "-r", f"__node:={name}")
    program = machine.start(*words, env=env)
    program.wait_for("Publishing")
    return program


@pytest.mark.parametrize(
    ("variable", "value", "sentence"),
    [
        ("ROS_DOMAIN_ID", "7", IGNORED),
        ("ZBOT_DOMAIN_ID", "seven", "ZBOT_DOMAIN_ID=seven is ignored"),
        ("ZBOT_HUB_PORT", "7500", "ZBOT_HUB_PORT=7500 is ignored"),
    ],
)
def test_what_was_joined_wins_over_a_variable(
    lesson: Lesson, variable: str, value: str, sentence: str
) -> None:
    env, name = {variable: value}, f"with_{variable.lower()}"
    program = greeter(lesson.ana, name, **env)
    lesson.watch.until(lambda nodes: (ANA, f"/{name}") in nodes)
    assert program.output.count(sentence) == 1
    assert "WARN" in program.output
    listed = lesson.ana.run("zbot", "node", "list", env=env)
    assert f"/{name}" in listed.out.split()
    assert sentence in lesson.ana.run("zbot", "status", env=env).out
    doctor = lesson.ana.run("zbot", "doctor", env=env)
    assert doctor.code == 0, doctor.out
    assert sentence in doctor.out
    program.stop()


def test_the_same_domain_in_a_variable_is_no_difference(lesson: Lesson) -> None:
    env = {"ROS_DOMAIN_ID": str(ANA)}
    program = greeter(lesson.ana, "quiet", **env)
    lesson.watch.until(lambda nodes: (ANA, "/quiet") in nodes)
    assert "WARN" not in program.output
    assert json.loads(lesson.ana.run("zbot", "status", "--json", env=env).out)["differences"] == []
    program.stop()


def test_a_domain_for_one_command_is_used_and_explained(lesson: Lesson) -> None:
    program = lesson.ana.start("zbot", "--domain", "7", "run", "talker")
    program.wait_for("Publishing")
    told = 'number 17 in class "Robots"; --domain 7 is used for this program, and the class does'
    assert program.output.count(told) == 1
    listed = lesson.ana.run("zbot", "--domain=7", "node", "list")
    assert "/talker" in listed.out.split()
    assert told in listed.err
    assert "/talker" not in lesson.ana.run("zbot", "node", "list").out.split()
    refused = lesson.ana.run("zbot", "--domain", "x", "node", "list")
    assert refused.code == 1
    assert "--domain is 'x', but a domain is a whole number" in refused.err
    program.stop()


IN_DOMAIN_8 = """
import zbot

with zbot.init(domain_id=8) as chosen:
    zbot.Node("chosen")
    print("domain", chosen.context.get_domain_id())
"""


def test_a_domain_in_a_program_is_used_and_explained(lesson: Lesson) -> None:
    ended = lesson.ana.run("python", "-c", IN_DOMAIN_8)
    assert "domain 8" in ended.out, ended.err
    assert "domain_id=8 is used for this program, and the class does not see it" in ended.err


def test_the_teachers_domain_is_not_taken_from_a_variable(lesson: Lesson) -> None:
    env = {"ROS_DOMAIN_ID": str(ANA)}
    program = greeter(lesson.teacher, "orders", **env)
    assert "ROS_DOMAIN_ID=17 is ignored; `zbot class stop` to use it" in program.output
    lesson.watch.until(lambda nodes: (0, "/orders") in nodes)
    program.stop()


def test_a_program_that_the_class_cannot_see_says_so(lesson: Lesson) -> None:
    program = greeter(lesson.ana, "hidden", ZBOT_DISCOVERY_RANGE="OFF")
    assert 'ZBOT_DISCOVERY_RANGE=OFF hides these nodes from class "Robots"' in program.output
    program.stop()
    (lesson.ana.home / "far.json5").write_text(ELSEWHERE)
    env = {"ZENOH_CONFIG": "far.json5"}
    ended = lesson.ana.run("greeter.py", env=env)
    assert ended.code == 1
    assert 'far.json5 sets `connect`, so class "Robots" does not see these nodes' in ended.err
    assert "cannot open a Zenoh session" in ended.err.splitlines()[-1]
    doctor = lesson.ana.run("zbot", "doctor", env=env)
    assert doctor.code == 1
    assert "far.json5 sets `connect`" in doctor.out


def test_a_configuration_that_changes_only_the_mode_stays_in_the_class(lesson: Lesson) -> None:
    (lesson.ana.home / "client.json5").write_text('{ mode: "client" }')
    program = greeter(lesson.ana, "as_client", ZENOH_CONFIG="client.json5")
    lesson.watch.until(lambda nodes: (ANA, "/as_client") in nodes)
    program.stop()
