"""Observer of a domain: prints who is in the graph and whose heartbeats came, ten times a second.

Run:        observer.py
Subscribes: heartbeat (std_msgs/String), see ring_node.py

Prints lines of JSON: `time` (monotonic, seconds), `nodes` (the names of all nodes) and `beats`: for
each node, the time and the contents of its last heartbeat.
"""

from __future__ import annotations

import contextlib
import json
import time
from typing import Any

import zbot

from std_msgs.msg import String

_PERIOD_S = 0.1


class Observer(zbot.Node):
    def __init__(self) -> None:
        super().__init__("observer")
        self.beats: dict[str, dict[str, Any]] = {}
        self.create_subscription(String, "heartbeat", self.on_beat, 1000)
        self.create_timer(_PERIOD_S, self.report)

    def on_beat(self, message: String) -> None:
        facts = json.loads(message.data)
        self.beats[facts["name"]] = {"time": time.monotonic(), **facts}

    def report(self) -> None:
        nodes = sorted(self.get_node_names())
        line = {"time": time.monotonic(), "nodes": nodes, "beats": self.beats}
        print(json.dumps(line), flush=True)


def main() -> None:
    with zbot.init(), contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
        zbot.spin(Observer())


if __name__ == "__main__":
    main()
