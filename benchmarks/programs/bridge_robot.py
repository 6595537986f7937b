"""Genuine node of ROS 2 that publishes at a rate, or measures what comes. See `benchmarks.bridge`.

The words are: publish TYPE TOPICS HERTZ SECONDS BYTES, or receive TYPE SECONDS.
"""

import json
import sys
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import QoSProfile

from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String

_TYPES = {"String": String, "Imu": Imu, "Image": Image}


def stamped(kind, size):
    """Return a message, and a function that writes the present time into it."""
    message = _TYPES[kind]()
    if kind == "String":

        def write():
            message.data = str(time.monotonic_ns()).ljust(size, ".")

        return message, write
    if kind == "Image":
        message.data = bytes(size)

    def stamp():
        now = time.monotonic_ns()
        message.header.stamp.sec, message.header.stamp.nanosec = divmod(now, 10**9)

    return message, stamp


def sent_ns(message):
    """Return the time that `stamped` has written."""
    if hasattr(message, "header"):
        return message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
    return int(message.data.rstrip("."))


def publish(kind, topics, hertz, seconds, size):
    node = rclpy.create_node("robot")
    profile = QoSProfile(depth=100)
    publishers = [node.create_publisher(_TYPES[kind], f"/m{i}", profile) for i in range(topics)]
    while not all(publisher.get_subscription_count() for publisher in publishers):
        time.sleep(0.1)
    time.sleep(2)
    print("begin", flush=True)
    message, write = stamped(kind, size)
    begin, count = time.monotonic(), 0
    while time.monotonic() < begin + seconds:
        for publisher in publishers:
            write()
            publisher.publish(message)
        count += 1
        time.sleep(max(0.0, begin + count / hertz - time.monotonic()))
    print(json.dumps({"sent": count * topics, "took_s": time.monotonic() - begin}), flush=True)
    time.sleep(2)


def receive(kind, seconds):
    node = rclpy.create_node("receiver")
    delays = []

    def take(message):
        delays.append(time.monotonic_ns() - sent_ns(message))

    node.create_subscription(_TYPES[kind], "/m0", take, QoSProfile(depth=100))
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    print(json.dumps(delays), flush=True)


def main():
    rclpy.init(args=[])
    if sys.argv[1] == "publish":
        publish(sys.argv[2], *map(int, sys.argv[3:5]), float(sys.argv[5]), int(sys.argv[6]))
    else:
        receive(sys.argv[2], float(sys.argv[3]))


if __name__ == "__main__":
    main()
