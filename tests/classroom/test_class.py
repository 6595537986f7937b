"""What a class sees of each other and what not, on machines with networks of their own."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from tests.classroom.rig import Rig, obstacle
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.classroom.machine import Machine
    from tests.conftest import Program

ANA, BEN = 17, 18
PIN = {"ZBOT_PIN": "4711"}


class Class:
    """A class of two, with or without a PIN.

    Args:
        rig: Its machines.
        options: Of `zbot class start`.
    """

    def __init__(self, rig: Rig, *options: str) -> None:
        self.teacher, (self.ana, self.ben) = rig.teacher, rig.laptops
        self.teacher.run("zbot", "class", "start", "Robots", *options, env=PIN)
        for machine, number, name in ((self.ana, ANA, "Ana"), (self.ben, BEN, "Ben")):
            joined = ("join", rig.teacher.address, "--number", str(number), "--name", name)
            assert machine.run("zbot", *joined, env=PIN).code == 0

    def is_linked(self, *machines: Machine) -> bool:
        """Return whether laptops are linked with the teacher's hub."""
        states = (machine.run("zbot", "status", "--json").out for machine in machines)
        return all(json.loads(state)["linked"] for state in states)


@pytest.fixture(scope="module", params=["with a PIN", "without a PIN"])
def lesson(request: pytest.FixtureRequest) -> Iterator[Class]:
    reason = obstacle()
    if reason is not None:
        pytest.skip(reason)
    with Rig(2) as rig:
        opened = Class(rig, *(["--pin"] if request.param == "with a PIN" else []))
        assert wait_until(lambda: opened.is_linked(opened.ana, opened.ben), 10)
        yield opened


def talker(machine: Machine, topic: str) -> Program:
    """Start a talker; return it when it talks."""
    program = machine.start("zbot", "run", "talker", "--ros-args", "-r", f"chatter:={topic}")
    program.wait_for("Publishing")
    return program


def echo(machine: Machine, topic: str, timeout_s: float = 10) -> str:
    """Return the first message of a topic that comes in time, or nothing."""
    words = ("topic", "echo", topic, "--once", "--timeout", str(timeout_s))
    return machine.run("zbot", *words).out


def test_the_teacher_looks_into_a_students_domain_by_name(lesson: Class) -> None:
    program = talker(lesson.ana, "/chatter")
    assert "Hello World" in echo(lesson.teacher, f"/{ANA}/chatter")
    topics = lesson.teacher.run("zbot", "topic", "list", f"/{ANA}").out.split()
    assert "/chatter" in topics
    assert "/talker" in lesson.teacher.run("zbot", "node", "list", f"/{ANA}").out
    info = lesson.teacher.run("zbot", "topic", "info", f"/{ANA}/chatter").out
    assert "Publisher count: 1" in info
    value = lesson.teacher.run("zbot", "param", "get", f"/{ANA}/talker", "use_sim_time")
    assert "False" in value.out
    program.stop()


def test_the_teacher_reaches_into_a_students_domain(lesson: Class) -> None:
    listener = lesson.ana.start("zbot", "topic", "echo", "/orders", "std_msgs/String")
    sent = ("topic", "pub", "--once", f"/{ANA}/orders", "std_msgs/String", "data: come here")
    lesson.teacher.run("zbot", *sent)
    listener.wait_for("come here")
    listener.stop()


BURSTS = """
import zbot
from std_msgs.msg import String

with zbot.init():
    node = zbot.Node("bursts")
    publishers = [node.create_publisher(String, f"burst_{k}", 10) for k in range(3)]

    def burst():
        for publisher in publishers:
            publisher.publish(String(data="all at once"))

    node.create_timer(0.1, burst)
    zbot.spin(node)
"""


def test_messages_of_several_topics_at_once_all_arrive(lesson: Class) -> None:
    program = lesson.ana.home / "bursts.py"
    program.write_text(BURSTS)
    ears = [
        lesson.teacher.start("zbot", "topic", "echo", f"/{ANA}/burst_{k}", "std_msgs/String")
        for k in range(3)
    ]
    bursts = lesson.ana.start("zbot", "run", str(program))
    for ear in ears:
        for _ in range(10):
            ear.wait_for("all at once")
    for one in (*ears, bursts):
        one.stop()


def test_students_are_alone_in_their_domains(lesson: Class) -> None:
    program = talker(lesson.ana, "/chatter")
    assert "Hello" in echo(lesson.ana, "/chatter")
    assert echo(lesson.ben, "/chatter", 2) == ""
    # Not even by saying so:
    assert echo(lesson.ben, f"/{ANA}/chatter", 2) == ""
    assert lesson.ben.run("zbot", "node", "list", f"/{ANA}").out == ""
    program.stop()


def test_what_the_teacher_shares_everybody_sees(lesson: Class) -> None:
    program = talker(lesson.teacher, "/class/news")
    for machine in (lesson.ana, lesson.ben):
        assert "/class/news" in machine.run("zbot", "topic", "list").out
        assert "Hello World" in echo(machine, "/class/news")
    program.stop()


def test_students_talk_to_everybody_only_once_the_teacher_allows_it(lesson: Class) -> None:
    program = talker(lesson.ana, "/class/talk")
    said = "reaches others only while the teacher lets students speak there"
    if said not in program.output:
        program.wait_for(said)
    assert echo(lesson.teacher, "/class/talk", 2) == ""
    lesson.teacher.run("zbot", "share", "class")
    assert "Hello World" in echo(lesson.ben, "/class/talk")
    lesson.teacher.run("zbot", "share", "class", "--stop")
    assert wait_until(lambda: lesson.is_linked(lesson.ana, lesson.ben), 10)
    assert echo(lesson.teacher, "/class/talk", 2) == ""
    program.stop()


def test_a_shared_domain_is_seen_by_the_one_it_is_shared_with(lesson: Class) -> None:
    program = talker(lesson.ana, "/chatter")
    shared = lesson.teacher.run("zbot", "share", str(ANA), str(BEN))
    assert f"{BEN} sees the topics of {ANA}" in shared.out
    assert "Hello World" in echo(lesson.ben, f"/{ANA}/chatter")
    # He hears, and does not speak there.
    listener = lesson.ana.start("zbot", "topic", "echo", "/orders", "std_msgs/String")
    sent = ("topic", "pub", f"/{ANA}/orders", "std_msgs/String", "data: hello", "--times", "3")
    lesson.ben.run("zbot", *sent, "--rate", "5", "-w", "0")
    lesson.teacher.run("zbot", "share", str(ANA), str(BEN), "--stop")
    assert wait_until(lambda: lesson.is_linked(lesson.ana, lesson.ben), 10)
    assert echo(lesson.ben, f"/{ANA}/chatter", 2) == ""
    listener.stop()
    assert "hello" not in listener.output
    program.stop()


def test_a_whole_class_is_marked(lesson: Class) -> None:
    good, wrong = talker(lesson.ana, "/student_id"), talker(lesson.ben, "/student_ID")
    task = "publishes std_msgs/String on /student_id at >= 1 Hz"
    marked = lesson.teacher.run("zbot", "class", "check", task, "--json")
    assert marked.code == 1
    ana, ben = json.loads(marked.out)
    assert ana["passes"]
    assert ben["problems"] == ["nobody publishes /student_id; is /student_ID meant?"]
    text = lesson.teacher.run("zbot", "class", "check", task).out
    assert "1 of 2 pass" in text
    good.stop()
    wrong.stop()


def test_nothing_on_a_students_laptop_listens_on_the_network(lesson: Class) -> None:
    listening = lesson.ana.start("zbot", "run", "talker")
    listening.wait_for("Publishing")
    sockets = lesson.ana.run("python3", "-c", LISTENING).out.split()
    assert sockets
    assert all(address == "0100007F" for address in sockets), sockets
    listening.stop()


# The local addresses of all listening sockets (state 0A): 127.0.0.1 is 0100007F.
LISTENING = """
for table in ("/proc/net/tcp", "/proc/net/tcp6"):
    for line in open(table).readlines()[1:]:
        words = line.split()
        if words[3] == "0A":
            print(words[1].split(":")[0])
"""


def test_two_machines_see_each_other_through_a_plain_hub() -> None:
    reason = obstacle()
    if reason is not None:
        pytest.skip(reason)
    with Rig(1) as rig:
        (robot,) = rig.laptops
        hub = rig.teacher.start("zbot", "hub")
        hub.wait_for("the hub listens on")
        hub.wait_for(f"zbot join {rig.teacher.address}")
        assert robot.run("zbot", "join", rig.teacher.address).code == 0
        program = talker(robot, "/chatter")
        assert "Hello World" in echo(rig.teacher, "/chatter")
        assert "/talker" in rig.teacher.run("zbot", "node", "list").out
        # The other way, node to node.
        back = talker(rig.teacher, "/answer")
        assert "Hello World" in echo(robot, "/answer")
        assert robot.run("zbot", "leave").code == 0
        assert "/talker" not in rig.teacher.run("zbot", "node", "list").out.split("\n")[1:]
        program.stop()
        back.stop()
        assert hub.stop() == 0


def test_machines_of_a_subnet_find_each_other_by_multicast() -> None:
    reason = obstacle()
    if reason is not None:
        pytest.skip(reason)
    subnet = {"ZBOT_DISCOVERY_RANGE": "SUBNET"}
    with Rig(2) as rig:
        for machine in rig.laptops:
            machine.join_air(isolated=False, multicast=True)
        first, second = rig.laptops
        program = first.start("zbot", "run", "talker", env=subnet)
        program.wait_for("Publishing")
        # Without a node of its own, and then with one.
        assert "/talker" in second.run("zbot", "node", "list", env=subnet).out
        listener = second.start("zbot", "run", "listener", env=subnet)
        listener.wait_for("Hello World")
        listener.stop()
        program.stop()
