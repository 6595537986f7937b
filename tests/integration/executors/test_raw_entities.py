"""Tests of waitables made of zbot's equivalents for the classes of rclpy's C extension."""

from __future__ import annotations

import importlib
from typing import Any

import pytest

import zbot
import zbot.compat  # noqa: F401 - makes rclpy importable
from tests.conftest import wait_until
from zbot.executor.clock import Clock
from zbot.executor.wait_set import WaitSet

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

raw: Any = importlib.import_module("rclpy.impl.implementation_singleton").rclpy_implementation
QOS = zbot.QoSProfile(depth=10).get_c_qos_profile()


def ready(kind: str, handle: Any, timeout_s: float = 5) -> bool:
    wait_set: Any = WaitSet()
    index = getattr(wait_set, f"add_{kind}")(handle)
    wait_set.wait(int(timeout_s * 1e9))
    return bool(wait_set.is_ready(kind, index))


def test_messages_are_taken_under_the_remapped_name(node: zbot.Node) -> None:
    with node.handle:
        subscription = raw.Subscription(node.handle, String, "words", QOS)
    assert subscription.get_topic_name() == "/words"
    assert not ready("subscription", subscription, 0)
    node.create_publisher(String, "words", 1).publish(String(data="hi"))
    assert ready("subscription", subscription)
    message, _ = subscription.take_message(String, False)
    assert message == String(data="hi")


def test_a_request_and_its_response_are_taken(node: zbot.Node) -> None:
    client = raw.Client(node.handle, AddTwoInts, "add", QOS)
    assert client.take_response(AddTwoInts.Response) == (None, None)
    client.send_request(AddTwoInts.Request())  # it is lost, because there is no server
    assert client.take_response(AddTwoInts.Response) == (None, None)
    service = raw.Service(node.handle, AddTwoInts, "add", QOS)
    assert wait_until(client.service_server_is_available)
    number = client.send_request(AddTwoInts.Request(a=1, b=2))
    assert ready("service", service)
    request, header = service.service_take_request(AddTwoInts.Request)
    assert header.request_id.sequence_number == number
    service.service_send_response(AddTwoInts.Response(sum=request.a + request.b), header)
    assert ready("client", client)
    header, response = client.take_response(AddTwoInts.Response)
    assert (header.sequence_number, response.sum) == (number, 3)
    assert header.request_id.sequence_number == number


def test_a_timers_call_is_taken_once(node: zbot.Node) -> None:
    clock = Clock(clock_type=zbot.ClockType.STEADY_TIME)
    with clock.handle, node.context.handle:
        timer = raw.Timer(clock.handle, node.context.handle, 500_000_000)
    assert not ready("timer", timer, 0)
    assert ready("timer", timer)
    timer.call_timer()
    assert not ready("timer", timer, 0)
    assert not ready("timer", raw.Timer(clock, node.context.handle, 0, False), 0)


def test_a_taken_call_of_a_timer_has_its_times(node: zbot.Node) -> None:
    clock = Clock(clock_type=zbot.ClockType.STEADY_TIME)
    timer = raw.Timer(clock.handle, node.context.handle, 500_000_000)
    assert timer.call_timer_with_info() is None
    assert ready("timer", timer)
    info = timer.call_timer_with_info()
    assert info.expected_call_time.nanoseconds <= info.actual_call_time.nanoseconds
    assert not ready("timer", timer, 0)


def test_a_guard_condition_is_triggered_by_its_handle(node: zbot.Node) -> None:
    guard = raw.GuardCondition(node.context.handle)
    assert not ready("guard_condition", guard, 0)
    guard.trigger_guard_condition()
    assert ready("guard_condition", guard)


def test_raw_entities_are_not_executed_and_end_with_their_node(
    node: zbot.Node, single: zbot.SingleThreadedExecutor
) -> None:
    subscription = raw.Subscription(node.handle, String, "words", QOS)
    node.create_publisher(String, "words", 1).publish(String(data="hi"))
    assert ready("subscription", subscription)
    single.spin_once(timeout_sec=0)
    assert subscription.entity.has_work
    node.destroy_node()
    with pytest.raises(zbot.ZbotError), subscription:
        pass
