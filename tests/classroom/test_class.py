"""Visibility between the machines of a class, on the testbed."""

from __future__ import annotations

import itertools
import json
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest

from tests.classroom.conftest import skip_without_namespaces
from tests.classroom.testbed import LanTestbed
from tests.classroom.watch import Watch
from tests.conftest import wait_until
from zbot.bag import read

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from tests.classroom.machine import Machine
    from tests.conftest import Program

ANA, BEN = 17, 18
PIN = {"ZBOT_PIN": "4711"}
SILENCE_S = 1.0  # in which a greeter says ten words


class Class:
    """A class of two, with or without a PIN.

    Args:
        testbed: Its machines.
        options: Of `zbot class start`.
    """

    def __init__(self, testbed: LanTestbed, *options: str) -> None:
        self.teacher, (self.ana, self.ben) = testbed.teacher, testbed.laptops
        self.teacher.run("zbot", "class", "start", "Robots", *options, env=PIN)
        with ThreadPoolExecutor() as pool:
            list(pool.map(self._join, (self.ana, self.ben), (ANA, BEN), ("Ana", "Ben")))
        self.watch = Watch(self.teacher)
        self.numbers = itertools.count()

    def _join(self, machine: Machine, number: int, name: str) -> None:
        joined = ("join", self.teacher.address, "--number", str(number), "--name", name)
        assert machine.run("zbot", *joined, env=PIN).code == 0

    @contextmanager
    def talking(self, machine: Machine, topic: str, name: str = "") -> Iterator[Program]:
        """Run a greeter for the length of a block, in which the teacher sees it."""
        name = name or f"greeter{next(self.numbers)}"  # an earlier one's may still be told of
        program = greeter(machine, topic, "-r", f"__node:={name}")
        self.watch.until(lambda nodes: f"/{name}" in {node for _, node in nodes})
        yield program
        program.stop()
        self.watch.until(lambda nodes: f"/{name}" not in {node for _, node in nodes})

    def is_linked(self, *machines: Machine) -> bool:
        """Return whether laptops are linked with the teacher's hub."""
        states = (machine.run("zbot", "status", "--json").out for machine in machines)
        return all(json.loads(state)["linked"] for state in states)


@pytest.fixture(scope="module", params=["with a PIN", "without a PIN"])
def lesson(request: pytest.FixtureRequest) -> Iterator[Class]:
    skip_without_namespaces()
    with LanTestbed(2) as testbed:
        opened = Class(testbed, *(["--pin"] if request.param == "with a PIN" else []))
        assert wait_until(lambda: opened.is_linked(opened.ana, opened.ben))
        yield opened


#: For what does not depend on the access rules of a class, which are more with a PIN.
with_pin = pytest.mark.parametrize("lesson", ["with a PIN"], indirect=True)


def greeter(machine: Machine, topic: str, *rules: str, **env: str) -> Program:
    """Start a greeter; return it when it talks."""
    words = ("--ros-args", "-r", f"chatter:={topic}", *rules)
    program = machine.start("greeter.py", *words, env=env)
    program.wait_for("Publishing")
    return program


def echo(machine: Machine, topic: str, timeout_s: float = 20) -> str:
    """Return the first message of a topic that comes in time, or nothing."""
    return machine.run(*echoing(topic, timeout_s)).out


def echoing(topic: str, timeout_s: float) -> tuple[str, ...]:
    return ("zbot", "topic", "echo", topic, "--once", "--timeout", str(timeout_s))


@with_pin
def test_the_teacher_looks_into_a_students_domain_by_name(lesson: Class) -> None:
    with lesson.talking(lesson.ana, "/chatter", "ana"):
        echoed, topics, nodes, info, value = lesson.teacher.run_all(
            echoing(f"/{ANA}/chatter", 20),
            ("zbot", "topic", "list", f"/{ANA}"),
            ("zbot", "node", "list", f"/{ANA}"),
            ("zbot", "topic", "info", f"/{ANA}/chatter"),
            ("zbot", "param", "get", f"/{ANA}/ana", "use_sim_time"),
        )
    assert "Hello World" in echoed.out
    assert "/chatter" in topics.out.split()
    assert "/ana" in nodes.out
    assert "Publisher count: 1" in info.out
    assert "False" in value.out


@with_pin
def test_the_teacher_can_publish_in_a_students_domain(lesson: Class) -> None:
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


@with_pin
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
    for running in (*ears, bursts):
        running.stop()


def test_students_are_alone_in_their_domains(lesson: Class) -> None:
    with lesson.talking(lesson.ana, "/chatter"):
        assert "Hello" in echo(lesson.ana, "/chatter")
        outputs = lesson.ben.run_all(
            echoing("/chatter", SILENCE_S),
            # Not even by saying so:
            echoing(f"/{ANA}/chatter", SILENCE_S),
            ("zbot", "node", "list", f"/{ANA}"),
        )
        assert [finished.out for finished in outputs] == [""] * 3


def test_everybody_sees_what_the_teacher_shares(lesson: Class) -> None:
    with lesson.talking(lesson.teacher, "/class/news"):
        for machine in (lesson.ana, lesson.ben):
            assert "Hello World" in echo(machine, "/class/news")
            assert "/class/news" in machine.run("zbot", "topic", "list").out


@with_pin
def test_a_laptop_without_programs_asks_its_hub(lesson: Class) -> None:
    for talker, listener, topic, shown in (
        (lesson.teacher, lesson.ana, "/class/news", ("/class/news",)),
        (lesson.ana, lesson.teacher, "/chatter", ("/chatter", f"/{ANA}")),
    ):
        name, *words = shown
        with lesson.talking(talker, topic):
            assert wait_until(lambda: not routers(listener), 20)  # noqa: B023 - called at once
            assert wait_until(
                lambda: name in listener.run("zbot", "topic", "list", *words).out.split(),  # noqa: B023
                10,
            )
            assert not routers(listener)


def routers(machine: Machine) -> list[Path]:
    """Return the files of the routers that run on a machine."""
    files = (machine.home / ".config" / "zbot").glob("router-*")
    return [file for file in files if file.read_text(encoding="utf-8")]


def test_students_talk_to_everybody_only_once_the_teacher_allows_it(lesson: Class) -> None:
    with lesson.talking(lesson.ana, "/class/talk") as program:
        said = "in /class/ only after the teacher allowed it with: zbot share class"
        if said not in program.output:
            program.wait_for(said)
        assert echo(lesson.teacher, "/class/talk", SILENCE_S) == ""
        lesson.teacher.run("zbot", "share", "class")
        assert "Hello World" in echo(lesson.ben, "/class/talk")
        lesson.teacher.run("zbot", "share", "class", "--stop")
        assert wait_until(lambda: lesson.is_linked(lesson.ana, lesson.ben))
        assert echo(lesson.teacher, "/class/talk", SILENCE_S) == ""


def test_a_shared_domain_is_seen_by_the_one_it_is_shared_with(lesson: Class) -> None:
    with lesson.talking(lesson.ana, "/chatter"):
        shared = lesson.teacher.run("zbot", "share", str(ANA), str(BEN))
        assert f"{BEN} sees the topics of {ANA}" in shared.out
        assert "Hello World" in echo(lesson.ben, f"/{ANA}/chatter")
        # He hears, and does not speak there.
        listener = lesson.ana.start("zbot", "topic", "echo", "/orders", "std_msgs/String")
        sent = ("topic", "pub", f"/{ANA}/orders", "std_msgs/String", "data: hello", "--times", "3")
        lesson.ben.run("zbot", *sent, "--rate", "5", "-w", "0")
        lesson.teacher.run("zbot", "share", str(ANA), str(BEN), "--stop")
        assert wait_until(lambda: lesson.is_linked(lesson.ana, lesson.ben))
        assert echo(lesson.ben, f"/{ANA}/chatter", SILENCE_S) == ""
        listener.stop()
        assert "hello" not in listener.output


def has_messages(bag: Path) -> bool:
    file = bag / f"{bag.name}_0.mcap"
    return file.exists() and file.stat().st_size > 2000


@with_pin
def test_a_whole_class_is_recorded_and_its_bags_are_checked(lesson: Class) -> None:
    folder = lesson.teacher.home / f"recorded{next(lesson.numbers)}"
    bags = folder / f"{ANA}_Ana", folder / f"{BEN}_Ben"
    with lesson.talking(lesson.ana, "/chatter"), lesson.talking(lesson.ben, "/words"):
        record = ("zbot", "class", "record", "-o", str(folder), "--topics", "/chatter", "words")
        recorder = lesson.teacher.start(*record)
        assert wait_until(lambda: all(map(has_messages, bags)), 20)
        assert recorder.stop() == 0
    assert [{topic for topic, _, _ in read(bag)} for bag in bags] == [{"/chatter"}, {"/words"}]
    expected = "publishes std_msgs/String on /chatter"
    marked = lesson.teacher.run("zbot", "class", "check", expected, "--bag", *map(str, bags))
    assert marked.out.splitlines() == [
        f"ok     {ANA}  Ana",
        f"FAIL   {BEN}  Ben  nobody publishes /chatter",
        "1 of 2 pass",
    ]
    refused = lesson.teacher.run("zbot", "class", "record", "--students", "99")
    assert "nobody in the class has the number 99" in refused.err


@with_pin
def test_a_whole_class_is_checked(lesson: Class) -> None:
    check = ("zbot", "class", "check", "publishes std_msgs/String on /student_id at >= 5 Hz")
    with lesson.talking(lesson.ana, "/student_id"), lesson.talking(lesson.ben, "/student_ID"):
        marked, text = lesson.teacher.run_all((*check, "--json"), check)
    assert marked.code == 1
    ana, ben = json.loads(marked.out)
    assert ana["passes"]
    assert ben["problems"] == ["nobody publishes /student_id; did you mean '/student_ID'?"]
    assert "1 of 2 pass" in text.out


def test_nothing_on_a_students_laptop_listens_on_the_network(lesson: Class) -> None:
    with lesson.talking(lesson.ana, "/chatter"):
        sockets = lesson.ana.run("python3", "-c", LISTENING).out.split()
    assert sockets
    assert all(address == "0100007F" for address in sockets), sockets


# The local addresses of all listening sockets (state 0A): 127.0.0.1 is 0100007F.
LISTENING = """
for table in ("/proc/net/tcp", "/proc/net/tcp6"):
    for line in open(table).readlines()[1:]:
        words = line.split()
        if words[3] == "0A":
            print(words[1].split(":")[0])
"""


def test_two_machines_see_each_other_through_a_plain_hub() -> None:
    skip_without_namespaces()
    with LanTestbed(1) as testbed:
        (robot,) = testbed.laptops
        hub = testbed.teacher.start("zbot", "hub")
        hub.wait_for("the hub listens on")
        hub.wait_for(f"zbot join {testbed.teacher.address}")
        assert robot.run("zbot", "join", testbed.teacher.address).code == 0
        program = greeter(robot, "/chatter")
        assert "Hello World" in echo(testbed.teacher, "/chatter")
        assert "/greeter" in testbed.teacher.run("zbot", "node", "list").out
        # The other way, node to node.
        back = greeter(testbed.teacher, "/answer")
        assert "Hello World" in echo(robot, "/answer")
        assert robot.run("zbot", "leave").code == 0
        assert "/greeter" not in testbed.teacher.run("zbot", "node", "list").out.split("\n")[1:]
        program.stop()
        back.stop()
        assert hub.stop() == 0


def test_machines_of_a_subnet_find_each_other_by_multicast() -> None:
    skip_without_namespaces()
    subnet = {"ZBOT_DISCOVERY_RANGE": "SUBNET"}
    with LanTestbed(2) as testbed:
        for machine in testbed.laptops:
            machine.connect_to_bridge(isolated=False, multicast=True)
        first, second = testbed.laptops
        program = greeter(first, "/chatter", **subnet)
        # Without a node of its own, and then with one.
        assert "/greeter" in second.run("zbot", "node", "list", env=subnet).out
        listener = second.start("zbot", "run", "listener", env=subnet)
        listener.wait_for("Hello World")
        listener.stop()
        program.stop()
