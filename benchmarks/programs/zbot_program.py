"""Programs of zbot, which the benchmark measures. Usage: zbot_program.py ROLE OPTIONS-AS-JSON."""

from __future__ import annotations

import time
from functools import partial
from typing import Any

import zbot
from program_control import (
    Delays,
    Tally,
    Trips,
    arguments,
    call_repeatedly,
    cpu,
    publish_for,
    say,
    serve,
)
from sample_messages import TYPES, message
from zbot.interfaces import has_sequences
from zbot.threads.wakeup import BusyWait
from zbot.wire.messagepack.codec import messagepack_codec_for

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import Int64, String

KEEP_ALL = zbot.QoSProfile(history=zbot.HistoryPolicy.KEEP_ALL)
_PAUSE_S = 0.01


def sink(node: zbot.Node, kind: str | int) -> None:
    tally = Tally()
    node.create_subscription(type(message(kind)), "flood", tally.count, KEEP_ALL)
    serve(tally.result)
    zbot.spin(node)


def flood(node: zbot.Node, kind: str | int, seconds: float, rate: float = 0.0) -> None:
    msg = message(kind)
    publisher = node.create_publisher(type(msg), "flood", KEEP_ALL)
    while not node.count_subscribers("flood"):
        time.sleep(_PAUSE_S)
    publish_for(partial(publisher.publish, msg), seconds, rate)


def listener(node: zbot.Node) -> None:
    delays = Delays()
    note = delays.note
    node.create_subscription(Int64, "time", lambda message: note(message.data), 10)
    serve(delays.result)
    zbot.spin(node)


def talker(node: zbot.Node, seconds: float, rate: float) -> None:
    publisher = node.create_publisher(Int64, "time", 10)
    while not node.count_subscribers("time"):
        time.sleep(_PAUSE_S)
    publish_for(lambda: publisher.publish(Int64(data=time.monotonic_ns())), seconds, rate)


def echo(node: zbot.Node, kind: str | int) -> None:
    msg_type = type(message(kind))
    publisher = node.create_publisher(msg_type, "pong", 10)
    node.create_subscription(msg_type, "ping", publisher.publish, 10)
    serve(cpu)
    zbot.spin(node)


def ping(node: zbot.Node, kind: str | int, count: int) -> None:
    msg = message(kind)
    publisher = node.create_publisher(type(msg), "ping", 10)
    trips = Trips(partial(publisher.publish, msg), count, zbot.shutdown)
    node.create_subscription(type(msg), "pong", trips.end, 10)
    while not (node.count_subscribers("ping") and node.count_publishers("pong")):
        time.sleep(_PAUSE_S)
    trips.begin()
    zbot.spin(node)


def server(node: zbot.Node) -> None:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, "add", add)
    zbot.spin(node)


def caller(node: zbot.Node, count: int) -> None:
    client = node.create_client(AddTwoInts, "add")
    client.wait_for_service()
    call_repeatedly(partial(client.call, AddTwoInts.Request(a=1, b=2)), count)


def timer(node: zbot.Node, rate: float, seconds: float) -> None:
    clock, late = node.get_clock(), list[int]()

    def on_timer(info: Any) -> None:
        late.append(clock.now().nanoseconds - info.expected_call_time.nanoseconds)
        if len(late) == count:
            say(late=late)
            zbot.shutdown()

    count = int(rate * seconds)
    node.create_timer(1 / rate, on_timer)
    zbot.spin(node)


def idle(node: zbot.Node) -> None:
    """Be a node of a usual program, with a publisher and a subscription."""
    node.create_publisher(String, "out", 10)
    node.create_subscription(String, "in", print, 10)
    say(ready=True)
    zbot.spin(node)


def observer(node: zbot.Node) -> None:
    """Tell when the graph has a number of nodes besides this one."""

    def listed(until: int) -> dict[str, Any]:
        while len(node.get_node_names()) <= until:
            time.sleep(_PAUSE_S)
        return {"at": time.time()}

    serve(listed)
    zbot.spin(node)


def facts() -> None:
    """Report the bytes of each encoded type, and the length of a keep-all queue for it."""
    found = {}
    for kind in TYPES:
        msg = message(kind)
        # zbot/node/subscription.py has these lengths.
        queue = 256 if has_sequences(type(msg)) else 8192
        found[kind] = {"bytes": len(messagepack_codec_for(type(msg)).encode(msg)), "queue": queue}
    say(**found)


def sleep_at_once(_: BusyWait, has_come: object) -> bool:  # noqa: ARG001 - as in BusyWait
    return False


def main() -> None:
    role, options = arguments()
    if role == "facts":
        facts()
        return
    if not options.pop("stays_awake", True):
        # zbot has no setting for this: only the benchmark replaces the method.
        BusyWait.begin = sleep_at_once  # type: ignore[method-assign,assignment]
    roles = {
        role.__name__: role
        for role in (
            sink,
            flood,
            listener,
            talker,
            echo,
            ping,
            server,
            caller,
            timer,
            idle,
            observer,
        )
    }
    with zbot.init(args=[]):
        node = zbot.Node(options.pop("node", role))
        roles[role](node, **options)


if __name__ == "__main__":
    main()
