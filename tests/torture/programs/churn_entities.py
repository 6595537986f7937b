"""Program that creates and destroys entities of one kind again and again.

Run: churn_entities.py KIND CYCLES BLOCKS

It prints the time of a cycle and the memory after each block of cycles.
"""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from zbot.action import ActionClient, ActionServer
from zbot.qos import DurabilityPolicy, QoSProfile

from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable

_LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def _ignore(*_: Any) -> None:
    """Take the place of a callback, which is never called."""


def cycles(node: zbot.Node) -> dict[str, Callable[[], object]]:
    """Return a function for each kind of entity, which creates one and destroys it."""

    def logging_node() -> None:
        other = zbot.Node("other", context=node.context)
        other.get_logger().info("a line")
        other.destroy_node()

    return {
        "publisher": lambda: node.destroy_publisher(node.create_publisher(String, "t", 10)),
        "latched publisher": lambda: node.destroy_publisher(
            node.create_publisher(String, "l", _LATCHED)
        ),
        "subscription": lambda: node.destroy_subscription(
            node.create_subscription(String, "t", _ignore, 10)
        ),
        "latched subscription": lambda: node.destroy_subscription(
            node.create_subscription(String, "l", _ignore, _LATCHED)
        ),
        "service": lambda: node.destroy_service(node.create_service(Trigger, "s", _ignore)),
        "client": lambda: node.destroy_client(node.create_client(Trigger, "s")),
        "timer": lambda: node.destroy_timer(node.create_timer(1.0, _ignore)),
        "guard condition": lambda: node.destroy_guard_condition(
            node.create_guard_condition(_ignore)
        ),
        "action server": lambda: ActionServer(node, Fibonacci, "a", _ignore).destroy(),
        "action client": lambda: ActionClient(node, Fibonacci, "a").destroy(),
        "node": lambda: zbot.Node("other", context=node.context).destroy_node(),
        "logging node": logging_node,
    }


def memory() -> int:
    """Return this process's resident memory in bytes."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def main() -> None:
    kind, count, blocks = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    with zbot.init():
        node = zbot.Node("churn")
        cycle = cycles(node)[kind]
        for _ in range(blocks):
            begin = time.perf_counter()
            for _ in range(count // blocks):
                cycle()
            each_us = (time.perf_counter() - begin) / (count // blocks) * 1e6
            print(json.dumps({"kind": "block", "each_us": each_us, "bytes": memory()}), flush=True)
        print(json.dumps({"kind": "end"}), flush=True)


if __name__ == "__main__":
    main()
