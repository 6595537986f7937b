"""Programs of rclpy, which the benchmark measures. Usage: rclpy_program.py ROLE OPTIONS-AS-JSON.

rclpy's publisher raises when its queue is full, and messages of a slow subscriber are overwritten.
So the profiles keep the last ten messages, and most messages of a flood are lost.
"""

from __future__ import annotations

import array
import time
from functools import partial
from typing import Any

import rclpy
from program_control import (
    Delays,
    Tally,
    Trips,
    arguments,
    call_repeatedly,
    cpu,
    publish_for,
    serve,
)
from sensor_msgs.msg import Imu
from std_msgs.msg import Int64, UInt8MultiArray
from std_srvs.srv import SetBool

_PAUSE_S = 0.05
_DISCOVERY_S = 1.0  # a publisher that is counted may not be connected yet


def message(kind: str | int) -> Any:
    """Return an `Imu`, or a `UInt8MultiArray` of a number of bytes."""
    return Imu() if kind == "Imu" else UInt8MultiArray(data=array.array("B", bytes(int(kind))))


def sink(node: Any, kind: str | int) -> None:
    tally = Tally()
    node.create_subscription(type(message(kind)), "flood", tally.count, 10)
    serve(tally.result)
    rclpy.spin(node)


def flood(node: Any, kind: str | int, seconds: float, rate: float = 0.0) -> None:
    msg = message(kind)
    publisher = node.create_publisher(type(msg), "flood", 10)
    while not node.count_subscribers("flood"):
        time.sleep(_PAUSE_S)
    time.sleep(_DISCOVERY_S)
    publish_for(partial(publisher.publish, msg), seconds, rate)


def listener(node: Any) -> None:
    delays = Delays()
    note = delays.note
    node.create_subscription(Int64, "time", lambda message: note(message.data), 10)
    serve(delays.result)
    rclpy.spin(node)


def talker(node: Any, seconds: float, rate: float) -> None:
    publisher = node.create_publisher(Int64, "time", 10)
    while not node.count_subscribers("time"):
        time.sleep(_PAUSE_S)
    time.sleep(_DISCOVERY_S)
    publish_for(lambda: publisher.publish(Int64(data=time.monotonic_ns())), seconds, rate)


def echo(node: Any, kind: int) -> None:  # noqa: ARG001 - as in the other programs
    publisher = node.create_publisher(UInt8MultiArray, "pong", 10)
    node.create_subscription(UInt8MultiArray, "ping", publisher.publish, 10)
    serve(cpu)
    rclpy.spin(node)


def ping(node: Any, kind: int, count: int) -> None:
    msg = message(kind)
    publisher = node.create_publisher(UInt8MultiArray, "ping", 10)
    trips = Trips(partial(publisher.publish, msg), count, rclpy.shutdown)
    node.create_subscription(UInt8MultiArray, "pong", trips.end, 10)
    while not (node.count_subscribers("ping") and node.count_publishers("pong")):
        time.sleep(_PAUSE_S)
    time.sleep(_DISCOVERY_S)
    trips.begin()
    while rclpy.ok():
        before = trips.count
        rclpy.spin_once(node, timeout_sec=1)
        if rclpy.ok() and trips.count == before:
            trips.begin()  # a message was lost


def server(node: Any) -> None:
    def turn(request: Any, response: Any) -> Any:
        response.success = request.data
        return response

    node.create_service(SetBool, "turn", turn)  # the wheels do not have AddTwoInts
    rclpy.spin(node)


def caller(node: Any, count: int) -> None:
    client = node.create_client(SetBool, "turn")
    client.wait_for_service()

    def call() -> None:
        rclpy.spin_until_future_complete(node, client.call_async(SetBool.Request(data=True)))

    call_repeatedly(call, count)


def main() -> None:
    role, options = arguments()
    rclpy.init()
    roles = {
        role.__name__: role for role in (sink, flood, listener, talker, echo, ping, server, caller)
    }
    roles[role](rclpy.create_node(role), **options)


if __name__ == "__main__":
    main()
