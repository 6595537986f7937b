"""Node of a student that wants too much: `class_attacker.py KIND`, a name of `ATTACKS`."""

from __future__ import annotations

import itertools
import sys
import time
from typing import TYPE_CHECKING, Any

import zbot

from rcl_interfaces.msg import ParameterEvent
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable


def names(node: zbot.Node) -> None:
    for number in itertools.count():
        publisher = node.create_publisher(String, f"name{number}", 10)
        publisher.publish(String(data="x"))
        node.destroy_publisher(publisher)


def nodes(_node: zbot.Node) -> None:
    for number in itertools.count():
        zbot.Node(f"attacker{number}").destroy_node()


def large(node: zbot.Node) -> None:
    _publish(node, String, "words", String(data="x" * 1_000_000), 1, 0.02)


def fast(node: zbot.Node) -> None:
    _publish(node, String, "words", String(data="x" * 1000), 50, 0.005)


def lines(node: zbot.Node) -> None:
    _repeat(lambda: node.get_logger().info("x" * 1000), 20, 0.01)


def events(node: zbot.Node) -> None:
    message = ParameterEvent(node="x" * 1000)
    _publish(node, ParameterEvent, "/parameter_events", message, 20, 0.01)


def _publish(
    node: zbot.Node, kind: type[Any], topic: str, message: Any, times: int, pause_s: float
) -> None:
    publisher = node.create_publisher(kind, topic, 10)
    _repeat(lambda: publisher.publish(message), times, pause_s)


def _repeat(act: Callable[[], object], times: int, pause_s: float) -> None:
    while True:
        for _ in range(times):
            act()
        time.sleep(pause_s)


def queries(node: zbot.Node) -> None:
    while True:
        for reply in node.context.session.get("**", timeout=1.0):
            del reply


ATTACKS: dict[str, Callable[[zbot.Node], None]] = {
    "new names of topics": names,
    "new nodes": nodes,
    "50 messages of 1 MB a second": large,
    "10,000 messages of 1 KB a second": fast,
    "2,000 log lines of 1 KB a second": lines,
    "2,000 parameter events of 1 KB a second": events,
    "queries of all names": queries,
}


def main() -> None:
    with zbot.init():
        node = zbot.Node("attacker")
        print("attacks", flush=True)
        ATTACKS[sys.argv[1]](node)


if __name__ == "__main__":
    main()
