"""Lighthouse whose keeper falls asleep: both sides hear of it."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import QoSProfile

from std_msgs.msg import Bool

rclpy.init()
node = rclpy.create_node("lighthouse")
told: dict[str, str] = {}
every = QoSProfile(depth=5, deadline=Duration(seconds=0.1))
lamp = node.create_publisher(
    Bool,
    "lamp",
    every,
    event_callbacks=PublisherEventCallbacks(
        matched=lambda event: told.setdefault("ship", f"{event.current_count} ship"),
        deadline=lambda event: told.setdefault("dark", f"dark since {event.total_count_change}"),
    ),
)
node.create_subscription(
    Bool,
    "lamp",
    lambda flash: told.setdefault("flash", f"flash {flash.data}"),
    every,
    event_callbacks=SubscriptionEventCallbacks(
        deadline=lambda event: told.setdefault("missed", f"missed {event.total_count > 0}")
    ),
)
executor = SingleThreadedExecutor()
executor.add_node(node)
lamp.publish(Bool(data=True))
for _ in range(200):
    executor.spin_once(timeout_sec=0.1)
    if len(told) == 4:
        break
for key in sorted(told):
    print(told[key])
(info,) = node.get_publishers_info_by_topic("lamp")
print(info.node_name, info.qos_profile.deadline.nanoseconds)
rclpy.shutdown()
