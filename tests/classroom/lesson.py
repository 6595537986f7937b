"""A class on the rig: a teacher's hub, joined laptops, and pupils' nodes that talk to each other."""

from __future__ import annotations

import json
import signal
import time
from typing import TYPE_CHECKING, Any

from tests.classroom.watch import Watch

if TYPE_CHECKING:
    from tests.classroom.machine import Machine
    from tests.classroom.rig import Rig
    from tests.conftest import Program

Node = tuple[int, str]  #: domain and name


class Lesson:
    def __init__(self, rig: Rig, nodes: int) -> None:
        self.rig = rig
        self.nodes = nodes
        self.pupils: dict[Node, Program] = {}
        self.hub = self.open_hub()
        self.watch = Watch(rig.teacher)

    def open_hub(self) -> Program:
        hub = self.rig.teacher.start("plain_hub.py", "tcp/0.0.0.0:7447")
        hub.wait_for("hub")
        return hub

    def join(self) -> None:
        dialled = f"tcp/{self.rig.teacher.address}:7447"
        hubs = [l.start("plain_hub.py", "tcp/127.0.0.1:7447", dialled) for l in self.rig.laptops]
        for hub in hubs:
            hub.wait_for("hub")

    def start(self) -> float:
        for index, laptop in enumerate(self.rig.laptops):
            number = index + 1
            for n in range(self.nodes):
                key = (number, f"/pupil{n}")
                nb = f"pupil{(n + 1) % self.nodes}"
                self.pupils[key] = laptop.start("pupil.py", f"pupil{n}", nb, env={"ZBOT_DOMAIN_ID": str(number)})
        last = time.monotonic()
        seen = self.watch.until(lambda nodes: self.pupils.keys() <= nodes, 60)
        return seen - last

    def stop(self):
        for p in self.pupils.values():
            p.process.send_signal(signal.SIGINT)
        return [self.result(p) for p in self.pupils.values()]

    def result(self, p) -> dict[str, Any]:
        p.wait(10)
        return json.loads(p.lines[-1])
