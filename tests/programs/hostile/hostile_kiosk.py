"""Kiosk whose texts contain control sequences of terminals, in every field that others can show.

Its argument is the text.
"""

import sys
from typing import Any

import rclpy
from kiosk.action import Boil
from kiosk.msg import Menu
from kiosk.srv import Order
from rclpy.action import ActionServer
from rclpy.lifecycle import LifecycleNode
from rclpy.qos import QoSProfile

from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from std_msgs.msg import String

evil = sys.argv[1]


def order(request: Any, response: Any) -> Any:
    if request.dish == "fail":
        raise ValueError(evil)
    response.receipt = evil
    return response


def boil(goal_handle: Any) -> Any:
    goal_handle.publish_feedback(Boil.Feedback(state=evil))
    goal_handle.succeed()
    return Boil.Result(dish=evil)


def refuse(_: object) -> SetParametersResult:
    return SetParametersResult(successful=False, reason=evil)


def publish() -> None:
    menu.publish(Menu(dish=evil))
    chat.publish(String(data=evil))
    node.get_logger().info(evil)


rclpy.init()
node = LifecycleNode("kiosk")
texts = ParameterDescriptor(description=evil, additional_constraints=evil, dynamic_typing=True)
node.declare_parameter("greeting", evil, texts)
node.declare_parameter("greetings", [evil], texts)
node.declare_parameter(f"names.{evil}", 1)
node.declare_parameter('" :zz="hit=1" "', "", texts)
node.add_on_set_parameters_callback(refuse)
menu = node.create_publisher(Menu, "menu", 10)
chat = node.create_publisher(String, "chat", 10)
node.create_service(Order, "order", order)
server = ActionServer(node, Boil, "boil", boil)
# A program that uses Zenoh directly can claim names that no node may have. A key has no `$`.
claim = evil.replace("$", "")
session = node.context.session
owner: dict[str, Any] = {
    "domain": node.context.get_domain_id(),
    "zid": str(session.zid()),
    "nid": 77,
}
claimed = {"namespace": "/", "node": claim, "name": f"/{claim}", "type_name": f"a/msg/{claim}"}
token = EndpointToken(
    **owner, **claimed, eid=78, kind=EntityKind.PUBLISHER, type_hash=claim, qos=QoSProfile(depth=1)
)
tokens = [
    session.liveliness().declare_token(NodeToken(**owner, namespace="/", node=claim).key),
    session.liveliness().declare_token(token.key),
]
node.create_timer(0.1, publish)
print("ready", flush=True)
rclpy.spin(node)
