"""Harbour with two contexts: what its names become, and who sees whom."""

import rclpy
from rclpy.context import Context
from rclpy.exceptions import InvalidTopicNameException
from rclpy.executors import SingleThreadedExecutor

from std_msgs.msg import String
from std_srvs.srv import Empty

context = Context()
rclpy.init(context=context)
rclpy.init(args=["--ros-args", "-r", "horn:=siren", "-r", "pilot:__node:=captain"])
office = rclpy.create_node("office", namespace="harbour", context=context)
pilot = rclpy.create_node("pilot", namespace="/harbour/boats")
pilot.create_publisher(String, "~/position", 10)
horn = pilot.create_publisher(String, "horn", 10)
office.create_subscription(String, "/harbour/boats/siren", print, 10)
office.create_service(Empty, "open_lock", lambda _, done: done)
print(pilot.get_fully_qualified_name(), horn.topic_name, office.resolve_topic_name("~/log"))
try:
    pilot.create_publisher(String, "left bank", 10)
except InvalidTopicNameException as error:
    print("invalid:", str(error).splitlines()[0])
executor = SingleThreadedExecutor(context=context)
executor.add_node(office)
seen = office.wait_for_node("/harbour/boats/captain", 60)
print("seen", seen, sorted(office.get_node_names_and_namespaces()))
lock = pilot.create_client(Empty, "/harbour/open_lock")
print("lock", lock.wait_for_service(60))
topics = dict(pilot.get_topic_names_and_types())
print(topics["/harbour/boats/captain/position"], pilot.count_subscribers("horn"))
services = dict(pilot.get_service_names_and_types_by_node("office", "/harbour"))
print(services["/harbour/open_lock"])
rclpy.shutdown()
print("default", rclpy.ok(), "own", context.ok())
office.destroy_node()
rclpy.shutdown(context=context)
print("own", context.ok())
