"""Tests that use each member of the entities of a node."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Any

import pytest
import rclpy
from rclpy.action import CancelResponse, GoalResponse
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor
from rclpy.qos import QoSProfile
from rclpy.service_introspection import ServiceIntrospectionState

from tests.conftest import wait_until
from tests.unit.compat.rclpy_calls.conftest import InUse, ignore, made

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

if TYPE_CHECKING:
    from rclpy.node import Node

    from tests.conftest import Spin


def test_publishers_and_subscriptions(node: Node) -> None:
    subscription = InUse(
        "rclpy.subscription.Subscription", node.create_subscription(String, "words", ignore, 10)
    )
    publisher = InUse("rclpy.publisher.Publisher", node.create_publisher(String, "words", 10))
    publisher.publish(String(data="a"))
    publisher.assert_liveliness()
    assert isinstance(publisher.wait_for_all_acked(Duration(seconds=1)), bool)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    assert wait_until(lambda: subscription.get_publisher_count() == 1)
    assert publisher.topic_name == subscription.topic_name == "/calls/words"
    assert publisher.logger_name == subscription.logger_name == "calls.caller"
    assert callable(subscription.callback)
    assert not subscription.is_cft_enabled
    subscription.set_content_filter("data = 'b'", [])
    assert subscription.get_content_filter().filter_expression == "data = 'b'"
    assert list(subscription.CallbackType)
    with publisher.handle, subscription.handle:
        pass
    publisher.destroy()
    subscription.destroy()


def test_services_and_clients(node: Node, spin: Spin) -> None:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    service = InUse("rclpy.service.Service", node.create_service(AddTwoInts, "add", add))
    client = InUse("rclpy.client.Client", node.create_client(AddTwoInts, "add"))
    spin(node)
    assert client.wait_for_service(60)
    assert client.service_is_ready()
    assert client.call(AddTwoInts.Request(a=1, b=2), timeout_sec=60).sum == 3
    future = client.call_async(AddTwoInts.Request())
    assert wait_until(future.done)
    client.remove_pending_request(future)
    with pytest.raises(KeyError):
        client.get_pending_request(99)
    for end in (service, client):
        off = ServiceIntrospectionState.OFF
        end.configure_introspection(node.get_clock(), QoSProfile(depth=1), off)
    assert client.service_name == service.service_name == "/calls/add"
    assert client.logger_name == service.logger_name == "calls.caller"
    with client.handle, service.handle:
        pass
    assert callable(service.send_response)  # its header comes from a pending request
    client.destroy()
    service.destroy()


def test_actions(node: Node, spin: Spin) -> None:
    held: list[InUse] = []

    def execute(goal: Any) -> Any:
        handle = InUse("rclpy.action.server.ServerGoalHandle", goal)
        held.append(handle)
        handle.publish_feedback(Fibonacci.Feedback(sequence=[0]))
        assert (handle.is_active, handle.is_cancel_requested) == (True, False)
        assert handle.request.order == len(held)
        assert (handle.status, len(handle.goal_id.uuid)) == (2, 16)
        (handle.succeed, handle.abort)[len(held) - 1]()
        return Fibonacci.Result()

    server = made("rclpy.action.server.ActionServer", node, Fibonacci, "count", execute)
    client = made("rclpy.action.client.ActionClient", node, Fibonacci, "count")
    server.register_execute_callback(execute)
    server.register_goal_callback(lambda _: GoalResponse.ACCEPT)
    server.register_cancel_callback(lambda _: CancelResponse.ACCEPT)
    server.register_handle_accepted_callback(lambda goal: goal.execute())
    spin(node, executor=MultiThreadedExecutor(context=node.context))
    assert client.wait_for_server(60)
    assert client.server_is_ready()
    assert client.send_goal(Fibonacci.Goal(order=1)).status == 4
    sent = client.send_goal_async(Fibonacci.Goal(order=2))
    assert wait_until(sent.done)
    handle = InUse("rclpy.action.client.ClientGoalHandle", sent.result())
    assert handle.accepted
    assert handle.get_result().status == 6
    answer = handle.get_result_async()
    assert wait_until(answer.done)
    assert handle.cancel_goal().goals_canceling == []
    assert wait_until(handle.cancel_goal_async().done)
    assert (len(handle.goal_id.uuid), handle.status) == (16, 6)
    assert handle.stamp.sec > 0
    for end in (client, server):
        off = ServiceIntrospectionState.OFF
        end.configure_introspection(node.get_clock(), QoSProfile(depth=1), off)
        end.get_num_entities()
    assert server.action_type is Fibonacci
    assert callable(server.notify_execute)  # `execute()` of a goal's handle calls it
    held[1].execute, held[1].canceled
    held[1].destroy()
    client.destroy()
    server.destroy()


def test_guard_conditions(node: Node) -> None:
    guard = InUse("rclpy.guard_condition.GuardCondition", node.create_guard_condition(ignore))
    guard.trigger()
    with guard.handle:
        pass
    guard.destroy()
    made("rclpy.signals.SignalHandlerGuardCondition", node.context).destroy()


def test_quality_of_service() -> None:
    profile = InUse("rclpy.qos.QoSProfile", QoSProfile(depth=3))
    assert profile.depth == 3
    assert profile.get_c_qos_profile() is not None
    for policy in ("history", "reliability", "durability", "liveliness"):
        assert isinstance(getattr(profile, policy), enum.Enum)
    for span in ("deadline", "lifespan", "liveliness_lease_duration"):
        assert isinstance(getattr(profile, span), Duration)
    assert not profile.avoid_ros_namespace_conventions


def test_events_of_quality_of_service(node: Node) -> None:
    publisher = node.create_publisher(
        String, "words", 1, event_callbacks=rclpy.event_handler.PublisherEventCallbacks()
    )
    handler = InUse("rclpy.event_handler.EventHandler", publisher.event_handlers[0])
    handler.destroy()
    assert callable(handler.execute)
