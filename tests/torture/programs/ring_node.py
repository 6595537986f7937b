"""Node of a ring: sends numbers to its neighbour with keep-all, and reports what it misses.

Run:        ring_node.py NAME OWN NEIGHBOUR [HZ]
Publishes:  ring_OWN (std_msgs/String, keep all), `RUN NUMBER`, where RUN tells this run of the node
            heartbeat (std_msgs/String), a line of JSON, five times a second
Subscribes: ring_NEIGHBOUR (keep all)

Prints lines of JSON: `ready`, `gap` and `end`.
"""

from __future__ import annotations

import contextlib
import json
import os
import sys
import time
from pathlib import Path
from typing import Any

import zbot
from zbot.qos import HistoryPolicy, QoSProfile

from std_msgs.msg import String

NOTHING_LOST = QoSProfile(history=HistoryPolicy.KEEP_ALL)
BEAT_S = 0.2


def say(**facts: Any) -> None:
    print(json.dumps({"time": time.monotonic(), **facts}), flush=True)


class RingNode(zbot.Node):
    def __init__(self, name: str, own: str, neighbour: str, hz: float) -> None:
        super().__init__(name)
        self.run = str(os.getpid())
        self.sent = self.received = 0
        self.last: tuple[str, int] = ("", 0)
        self.words = self.create_publisher(String, f"ring_{own}", NOTHING_LOST)
        self.beats = self.create_publisher(String, "heartbeat", 10)
        self.create_subscription(String, f"ring_{neighbour}", self.on_word, NOTHING_LOST)
        self.create_timer(1 / hz, self.send)
        self.create_timer(BEAT_S, self.beat)

    def send(self) -> None:
        self.sent += 1
        self.words.publish(String(data=f"{self.run} {self.sent}"))

    def beat(self) -> None:
        facts = {"name": self.get_name(), "run": self.run, "sent": self.sent, "last": self.last}
        self.beats.publish(String(data=json.dumps(facts)))

    def on_word(self, message: String) -> None:
        run, number = message.data.split()
        self.received += 1
        if run == self.last[0] and int(number) != self.last[1] + 1:
            say(kind="gap", run=run, last=self.last[1], next=int(number))
        self.last = run, int(number)


def is_in_mesh() -> bool:
    """Return whether this process has one of the domain's places for peers."""
    return any("/mesh-" in str(file.resolve()) for file in Path("/proc/self/fd").iterdir())


def main() -> None:
    name, own, neighbour, *hz = sys.argv[1:]
    with zbot.init():
        node = RingNode(name, own, neighbour, float(hz[0]) if hz else 10)
        say(kind="ready", run=node.run, is_in_mesh=is_in_mesh())
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(node)
        say(kind="end", sent=node.sent, received=node.received)


if __name__ == "__main__":
    main()
