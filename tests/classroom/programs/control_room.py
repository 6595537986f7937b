"""Counts what telemetry.py sends, knows what it missed, and answers its questions.

Run:        control_room.py [--last N]
Subscribes: telemetry (std_msgs/String, reliable, keep all)
Serves:     check (std_srvs/Trigger)

Prints `receiving`, `first` with the first message, `gap FIRST NEXT TIME` when numbers are missing,
`last` with number N, and when interrupted a line of JSON: received, gaps (from, to), how many
losses zbot told it of.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import time
from typing import TYPE_CHECKING

import zbot
from zbot import HistoryPolicy, QoSProfile, ReliabilityPolicy
from zbot.node.event_callbacks import SubscriptionEventCallbacks

from std_msgs.msg import String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from zbot.node.qos_events import QoSMessageLostInfo

NOTHING_LOST = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE)


class ControlRoom(zbot.Node):
    def __init__(self, last: int) -> None:
        super().__init__("control_room")
        self.last = last
        self.received = 0
        self.heard: int | None = None
        self.repeated = 0
        self.gaps: list[tuple[int, int]] = []
        self.told_lost = 0
        self.slowest_ms = 0.0
        events = SubscriptionEventCallbacks(message_lost=self.on_lost)
        self.create_subscription(
            String, "telemetry", self.on_number, NOTHING_LOST, event_callbacks=events
        )
        self.create_service(Trigger, "check", self.on_check)

    def on_number(self, msg: String) -> None:
        number, sent_ns = map(int, msg.data.split()[:2])
        self.received += 1
        self.slowest_ms = max(self.slowest_ms, (time.monotonic_ns() - sent_ns) / 1e6)
        if self.heard is None:
            print("first", number, flush=True)
        elif number <= self.heard:
            self.repeated += 1
        elif number != self.heard + 1:
            self.gaps.append((self.heard, number))
            print("gap", self.heard, number, time.monotonic_ns(), flush=True)
        self.heard = number
        if number == self.last:
            print("last", flush=True)

    def on_lost(self, info: QoSMessageLostInfo) -> None:
        self.told_lost = info.total_count

    def on_check(self, _: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        response.success = True
        return response


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--last", type=int, default=0)
    options, _ = parser.parse_known_args()
    with zbot.init():
        room = ControlRoom(options.last)
        print("receiving", flush=True)
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(room)
        report = {
            "received": room.received,
            "last": room.heard,
            "repeated": room.repeated,
            "gaps": room.gaps,
            "told_lost": room.told_lost,
            "slowest_ms": room.slowest_ms,
        }
        print(json.dumps(report), flush=True)


if __name__ == "__main__":
    main()
