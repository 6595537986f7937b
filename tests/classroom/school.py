"""School: the machines of a teacher with a class and of students, with real hubs, without root."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.local_machine import LocalMachine
    from tests.conftest import Program, Start

PIN = "4711"

TALKER = """
import zbot
from std_msgs.msg import String

with zbot.init():
    node = zbot.Node("talker")
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.05, lambda: publisher.publish(String(data="hello")))
    node.get_logger().error("the motor is hot")
    print("ready", flush=True)
    zbot.spin(node)
"""


class School:
    """A teacher with an open class, and students.

    Args:
        make: Makes machines.
        start: Starts programs.
    """

    def __init__(self, make: Callable[[str], LocalMachine], start: Start) -> None:
        self._make, self._start = make, start
        self.teacher = make("teacher")
        self.address = f"127.0.0.1:{self.teacher.port}"

    def open(self, *words: str) -> dict[str, Any]:
        """Open the class with the PIN; return what `zbot class start` prints."""
        told = self.teacher.succeed(
            "class", "start", "Robots", "--pin", "--json", *words, ZBOT_PIN=PIN
        )
        opened: dict[str, Any] = json.loads(told)
        return opened

    def join(self, name: str, *words: str) -> LocalMachine:
        """Let a student join."""
        student = self._make(name)
        student.succeed("join", self.address, "--name", name, *words, ZBOT_PIN=PIN)
        return student

    def run(self, machine: LocalMachine, source: str, **more: str) -> Program:
        """Start a program on a machine."""
        return self._start(source=source, env={**machine.environment, "ZBOT_DOMAIN_ID": "", **more})

    def listed(self) -> dict[int, dict[str, Any]]:
        """Return the students in the teacher's list, by number."""
        found = json.loads(self.teacher.succeed("class", "list", "--json"))
        return {student["number"]: student for student in found["students"]}


def is_linked(machine: LocalMachine) -> bool:
    """Return whether the hub of a machine is linked with the teacher's."""
    return bool(json.loads(machine.succeed("status", "--json"))["linked"])
