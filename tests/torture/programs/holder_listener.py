"""Node that looks for gaps in the numbers of holder_talker.py.

Run:        holder_listener.py
Subscribes: numbers (std_msgs/Int64, keep all)

Prints lines of JSON: `ready`, `gap`, and at the end `end` with the number of messages.
"""

from __future__ import annotations

import contextlib
import json
import time
from typing import Any

import zbot
from zbot.qos import HistoryPolicy, QoSProfile

from std_msgs.msg import Int64


def say(**facts: Any) -> None:
    print(json.dumps({"time": time.monotonic(), **facts}), flush=True)


class Listener(zbot.Node):
    def __init__(self) -> None:
        super().__init__("listener")
        self.last: dict[int, int] = {}
        self.received = self.gaps = 0
        profile = QoSProfile(history=HistoryPolicy.KEEP_ALL)
        self.create_subscription(Int64, "numbers", self.on_number, profile)

    def on_number(self, message: Int64) -> None:
        talker, number = divmod(message.data, 10**9)
        self.received += 1
        last = self.last.get(talker)
        if last is not None and number != last + 1:
            self.gaps += 1
            say(kind="gap", talker=talker, last=last, next=number)
        self.last[talker] = number


def main() -> None:
    with zbot.init():
        node = Listener()
        say(kind="ready")
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(node)
        say(kind="end", received=node.received, gaps=node.gaps)


if __name__ == "__main__":
    main()
