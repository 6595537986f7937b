"""Node that publishes numbers at 100 Hz with keep-all.

Run:       holder_talker.py NUMBER
Publishes: numbers (std_msgs/Int64), the program's number times 10^9 plus the message's number
"""

from __future__ import annotations

import contextlib
import json
import sys

import zbot
from zbot.qos import HistoryPolicy, QoSProfile

from std_msgs.msg import Int64


class Talker(zbot.Node):
    def __init__(self, number: int) -> None:
        super().__init__(f"talker{number}")
        self.next = number * 10**9
        profile = QoSProfile(history=HistoryPolicy.KEEP_ALL)
        self.numbers = self.create_publisher(Int64, "numbers", profile)
        self.create_timer(0.01, self.send)

    def send(self) -> None:
        self.next += 1
        self.numbers.publish(Int64(data=self.next))


def main() -> None:
    with zbot.init():
        node = Talker(int(sys.argv[1]))
        print(json.dumps({"kind": "ready"}), flush=True)
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(node)


if __name__ == "__main__":
    main()
