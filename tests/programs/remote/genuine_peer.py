"""Node of a genuine ROS 2 that does what a test tells it, in lines of JSON on standard input.

Each command gets one line of JSON as its answer. The first argument is the name of the node.
"""

import contextlib
import importlib
import json
import sys
import threading
import time

import rclpy
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message, serialize_message
from test_msgs.action import Fibonacci


def class_of(name):
    package, kind, short = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), short)


def profile(reliability="reliable", durability="volatile", depth=10):
    return QoSProfile(
        depth=depth,
        reliability=ReliabilityPolicy[reliability.upper()],
        durability=DurabilityPolicy[durability.upper()],
    )


class Peer:
    def __init__(self, name):
        self.node = rclpy.create_node(name)
        self.publishers = {}
        self.received = {}
        self.clients = {}
        self.goals = []

    def advertise(self, topic, type, **qos):
        self.publishers[topic] = self.node.create_publisher(class_of(type), topic, profile(**qos))

    def publish(self, topic, data):
        self.publishers[topic].publish(bytes.fromhex(data))

    def stream(self, topic, count, hertz):
        """Publish strings with the numbers 0, 1, 2 ... in the background."""
        publisher = self.publishers[topic]
        message = class_of("std_msgs/msg/String")

        def run():
            begin = time.monotonic()
            for number in range(count):
                publisher.publish(message(data=str(number)))
                time.sleep(max(0, begin + (number + 1) / hertz - time.monotonic()))

        threading.Thread(target=run, daemon=True).start()

    def streams(self, count, hertz, seconds):
        """Publish strings on the topics /stream_0, /stream_1 ... in the background."""
        string = class_of("std_msgs/msg/String")
        publishers = [
            self.node.create_publisher(string, f"/stream_{index}", profile(depth=100))
            for index in range(count)
        ]

        def run():
            begin, number = time.monotonic(), 0
            while time.monotonic() < begin + seconds:
                for publisher in publishers:
                    publisher.publish(string(data=str(number)))
                number += 1
                time.sleep(max(0, begin + number / hertz - time.monotonic()))
            for publisher in publishers:
                publisher.publish(string(data="end"))

        self._streams = publishers
        threading.Thread(target=run, daemon=True).start()

    def listen(self, topic, type, **qos):
        self.received[topic] = received = []
        self.node.create_subscription(
            class_of(type),
            topic,
            lambda data: received.append(data.hex()),
            profile(**qos),
            raw=True,
        )

    def heard(self, topic):
        return self.received[topic]

    def echo(self, type, source, target, **qos):
        """Publish each message again, as an object that rclpy has decoded and encodes."""
        publisher = self.node.create_publisher(class_of(type), target, profile(**qos))
        self.node.create_subscription(class_of(type), source, publisher.publish, profile(**qos))

    def subscriber_count(self, topic):
        return self.node.count_subscribers(topic)

    def publisher_count(self, topic):
        return self.node.count_publishers(topic)

    def serve_bool(self, name, success=True, silent=False):
        def answer(request, response):
            if silent:
                threading.Event().wait()
            response.success, response.message = success, f"got {request.data}"
            return response

        self.node.create_service(class_of("std_srvs/srv/SetBool"), name, answer)

    def call_bool(self, name, data):
        service = class_of("std_srvs/srv/SetBool")
        client = self.clients.setdefault(name, self.node.create_client(service, name))
        if not client.wait_for_service(10):
            return None
        future = client.call_async(service.Request(data=data))
        deadline = time.monotonic() + 10
        while not future.done() and time.monotonic() < deadline:
            time.sleep(0.01)
        return [future.result().success, future.result().message] if future.done() else None

    def begin_call(self, name, data):
        """Send a request without waiting for the response."""
        service = class_of("std_srvs/srv/SetBool")
        client = self.clients.setdefault(name, self.node.create_client(service, name))
        if not client.wait_for_service(10):
            return False
        client.call_async(service.Request(data=data))
        return True

    def declare(self, name, value):
        self.node.declare_parameter(name, value)

    def parameter(self, name):
        return self.node.get_parameter(name).value

    def serve_fibonacci(self, name, until_canceled=False):
        def execute(goal):
            self.goals.append(bytes(goal.goal_id.uuid).hex())
            goal.publish_feedback(Fibonacci.Feedback(sequence=[0, 1]))
            if until_canceled:
                while not goal.is_cancel_requested:
                    time.sleep(0.01)
                goal.canceled()
                return Fibonacci.Result(sequence=[9])
            goal.succeed()
            return Fibonacci.Result(sequence=[0, 1, 1, 2])

        self.server = ActionServer(
            self.node,
            Fibonacci,
            name,
            execute,
            goal_callback=lambda _: GoalResponse.ACCEPT,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )

    def goal_ids(self):
        return self.goals

    def send_fibonacci(self, name, order):
        client = ActionClient(self.node, Fibonacci, name)
        if not client.wait_for_server(10):
            return None
        feedback = []
        sent = client.send_goal_async(
            Fibonacci.Goal(order=order),
            feedback_callback=lambda message: feedback.append(list(message.feedback.sequence)),
        )
        deadline = time.monotonic() + 10
        while not sent.done() and time.monotonic() < deadline:
            time.sleep(0.01)
        result = sent.result().get_result_async()
        while not result.done() and time.monotonic() < deadline:
            time.sleep(0.01)
        identity = bytes(sent.result().goal_id.uuid).hex()
        return [identity, list(result.result().result.sequence), feedback, result.result().status]

    def nodes(self):
        return sorted(self.node.get_node_names())

    def has_server(self, name):
        """Return whether a service that was called has a server now."""
        return self.clients[name].service_is_ready()

    def again(self, type, data):
        """Return the bytes of a message that rclpy has decoded and encoded."""
        cls = class_of(type)
        return serialize_message(deserialize_message(bytes.fromhex(data), cls)).hex()


def main():
    rclpy.init(args=[])
    peer = Peer(sys.argv[1])
    executor = MultiThreadedExecutor(8)
    executor.add_node(peer.node)

    def spin():
        with contextlib.suppress(ExternalShutdownException):
            executor.spin()

    threading.Thread(target=spin, daemon=True).start()
    print(json.dumps("ready"), flush=True)
    for line in sys.stdin:
        operation, options = json.loads(line)
        try:
            answer = getattr(peer, operation)(**options)
        except Exception as error:
            answer = {"error": repr(error)}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
