"""Sends numbers that must not be lost, and asks a question every second.

Run:       telemetry.py [--hz 20] [--size 20] [--count N]      endless without a count
Publishes: telemetry (std_msgs/String, reliable, keep all), a number, the monotonic time in ns,
           and zeros up to SIZE characters
Calls:     check (std_srvs/Trigger), waiting 5 s at most

Prints `sending`, `answered` after each call that was, and when interrupted a line of JSON: sent,
the longest that a publish() took in ms, and the calls: [seconds it took, outcome] each.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import threading
import time

import zbot
from zbot import HistoryPolicy, QoSProfile, ReliabilityPolicy
from zbot.node.errors import ServiceError

from std_msgs.msg import String
from std_srvs.srv import Trigger

NOTHING_LOST = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE)
PATIENCE_S = 5.0


class Telemetry(zbot.Node):
    def __init__(self, hz: float, size: int, count: int) -> None:
        super().__init__("telemetry")
        self.sent = 0
        self.size = size
        self.count = count
        self.longest_ms = 0.0
        self.calls: list[tuple[float, str]] = []
        self.numbers = self.create_publisher(String, "telemetry", NOTHING_LOST)
        self.check = self.create_client(Trigger, "check")
        self.create_timer(1 / hz, self.send)

    def send(self) -> None:
        if self.count and self.sent == self.count:
            return
        begun = time.monotonic_ns()
        self.sent += 1
        self.numbers.publish(String(data=f"{self.sent} {begun} ".ljust(self.size, "0")))
        self.longest_ms = max(self.longest_ms, (time.monotonic_ns() - begun) / 1e6)

    def ask(self, stopped: threading.Event) -> None:
        self.check.wait_for_service(10)
        while not stopped.wait(1):
            begun = time.monotonic()
            try:
                self.check.call(Trigger.Request(), timeout_sec=PATIENCE_S)
                outcome = "answered"
                print(outcome, flush=True)
            except TimeoutError:
                outcome = "timeout"
            except ServiceError as exc:
                outcome = exc.kind
            self.calls.append((round(time.monotonic() - begun, 3), outcome))


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--hz", type=float, default=20)
    parser.add_argument("--size", type=int, default=20)
    parser.add_argument("--count", type=int, default=0)
    options, _ = parser.parse_known_args()
    stopped = threading.Event()
    with zbot.init():
        node = Telemetry(options.hz, options.size, options.count)
        asking = threading.Thread(target=node.ask, args=(stopped,))
        asking.start()
        print("sending", flush=True)
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(node)
        stopped.set()
        asking.join(2 * PATIENCE_S)
        report = {"sent": node.sent, "longest_publish_ms": node.longest_ms, "calls": node.calls}
        print(json.dumps(report), flush=True)


if __name__ == "__main__":
    main()
