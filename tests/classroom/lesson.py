"""Class on the testbed: a teacher and joined laptops, each with nodes that talk to each other."""

from __future__ import annotations

import json
import os
import signal
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tests.classroom.watch import Watch

if TYPE_CHECKING:
    from tests.classroom.machine import Machine
    from tests.classroom.testbed import LanTestbed
    from tests.conftest import Program

Node = tuple[int, str]  #: domain and name


@dataclass(frozen=True)
class Heard:
    """What a pupil's node received from the next node."""

    received: int
    lost: int
    delays_us: list[int]


class Lesson:
    """An open class, and everybody's nodes.

    Args:
        testbed: The machines.
        nodes: How many each laptop runs.
        pin: The class's PIN; empty for none.
        hz: How often each node speaks.
    """

    def __init__(self, testbed: LanTestbed, nodes: int, *, pin: str = "", hz: float = 10) -> None:
        self.testbed = testbed
        self._pin = {"ZBOT_PIN": pin} if pin else {}
        self.has_pin = bool(pin)
        self._nodes = nodes
        self._hz = hz
        self._pupils: dict[Node, Program] = {}
        self.seen_after_s = 0.0  #: from the last node's start until the teacher saw all
        self.code = self.open_class()
        self.watch = Watch(testbed.teacher)

    # -- teacher -------------------------------------------------------------------------------

    def open_class(self) -> str:
        """Open the class, or open it again; return its code."""
        pin = ["--pin"] if self._pin else []
        opened = self.testbed.teacher.run(
            *("zbot", "class", "start", "Robots", "--json", *pin), env=self._pin
        )
        assert opened.code == 0, opened.err
        return str(json.loads(opened.out)["code"])

    def kill_hub(self) -> None:
        """Kill the teacher's hub as a power cut would; see that it is gone."""
        os.kill(hub_pid(self.testbed.teacher), signal.SIGKILL)
        self.watch.until(lambda nodes: not nodes)

    # -- students ------------------------------------------------------------------------------

    def number_of(self, laptop: Machine) -> int:
        """Return a laptop's number in the class, which is its domain."""
        return 1 + self.testbed.laptops.index(laptop)

    def join(self) -> None:
        """Let all laptops join by the code, at the same time."""
        with ThreadPoolExecutor(4) as pool:
            list(pool.map(self._join, self.testbed.laptops))

    def _join(self, laptop: Machine) -> None:
        number = str(self.number_of(laptop))
        joined = laptop.run("zbot", "join", self.code, "--number", number, env=self._pin)
        assert joined.code == 0, joined.err

    def domain_of(self, laptop: Machine) -> dict[str, str]:
        """Return the environment in which a laptop's programs are in its own domain."""
        return {"ZBOT_COMMAND_DOMAIN": str(self.number_of(laptop))}

    def start_nodes(self, *, by_turns: bool = False) -> None:
        """Start everybody's nodes, and wait until the teacher sees all.

        Args:
            by_turns: Let a laptop's nodes be made before the next begins, as this machine has not
                the processors of so many.
        """
        last = time.monotonic()
        for laptop in self.testbed.laptops:
            for position in range(self._nodes):
                neighbour = f"pupil{(position + 1) % self._nodes}"
                last = time.monotonic()
                self.start_node(laptop, f"pupil{position}", neighbour)
            for node in self.nodes_of(laptop) if by_turns else ():
                self._pupils[node].wait_for("node", 60)
        self.seen_after_s = self.watch.until(self.all_there, 60) - last

    def start_node(self, laptop: Machine, name: str, neighbour: str) -> Program:
        """Start a pupil's node."""
        program = laptop.start("pupil.py", name, neighbour, "--hz", str(self._hz))
        self._pupils[self.number_of(laptop), f"/{name}"] = program
        return program

    def all_there(self, nodes: set[Node]) -> bool:
        """Return whether every started node is among those that the teacher sees."""
        return self._pupils.keys() <= nodes

    def nodes_of(self, laptop: Machine) -> set[Node]:
        """Return the nodes that were started on a laptop."""
        return {node for node in self._pupils if node[0] == self.number_of(laptop)}

    def end_nodes(self) -> list[Heard]:
        """Interrupt all nodes; return what each heard."""
        for program in self._pupils.values():
            program.process.send_signal(signal.SIGINT)
        heard = [self._last_words(program) for program in self._pupils.values()]
        self._pupils.clear()
        return heard

    @staticmethod
    def _last_words(program: Program) -> Heard:
        program.wait(20)
        return Heard(**json.loads(program.lines[-1]))


def hub_pid(machine: Machine) -> int:
    """Return the process id of the hub that a command left running on a machine."""
    state = machine.home / ".config" / "zbot" / "hub.json"
    return int(json.loads(state.read_text(encoding="utf-8"))["pid"])
