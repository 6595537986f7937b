"""Tests of parameter events and of their handlers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.parameters.errors import UnknownCallbackError
from zbot.parameters.parameter import Parameter
from zbot.remote.parameter_event_handler import ParameterEventHandler

from rcl_interfaces.msg import ParameterEvent

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from zbot.remote.parameter_client import AsyncParameterClient

SPEED: Any = [Parameter("speed", value=1)]  # rclpy accepts these in place of messages


def test_every_change_is_published(node: zbot.Node, client: AsyncParameterClient) -> None:
    events: list[ParameterEvent] = []
    subscription = client.on_parameter_event(events.append)
    assert wait_until(lambda: node.count_subscribers("/parameter_events") == 1)
    node.declare_parameter("speed", 1.0)
    node.set_parameters([Parameter("speed", value=2.0)])
    node.undeclare_parameter("speed")
    assert wait_until(lambda: len(events) == 3)
    assert [event.node for event in events] == ["/lab/robot"] * 3
    assert [parameter.name for parameter in events[0].new_parameters] == ["speed"]
    assert [parameter.value.double_value for parameter in events[1].changed_parameters] == [2.0]
    assert [parameter.value.type for parameter in events[2].deleted_parameters] == [0]
    assert events[0].stamp.sec > 0
    assert subscription.topic_name == "/parameter_events"


def test_a_handler_calls_the_callbacks_of_the_changed_parameter(
    node: zbot.Node, make_context: MakeContext, spin: Spin
) -> None:
    watcher = zbot.Node("watcher", context=make_context(), namespace="lab")
    handler = ParameterEventHandler(watcher)
    heard: list[Any] = []
    of_speed = handler.add_parameter_callback(
        "speed", "robot", lambda parameter: heard.append(("speed", parameter.value.double_value))
    )
    handler.add_parameter_callback("speed", "/other", lambda _: heard.append("wrong node"))
    handler.add_parameter_callback("use_sim_time", "", lambda _: heard.append("own"))
    of_all = handler.add_parameter_event_callback(lambda event: heard.append(event.node))
    spin(watcher)
    assert wait_until(lambda: node.count_subscribers("/parameter_events") == 1)
    node.declare_parameter("speed", 1.0)
    assert wait_until(lambda: len(heard) == 2)
    assert heard == [("speed", 1.0), "/lab/robot"]
    watcher.set_parameters([Parameter("use_sim_time", value=False)])
    assert wait_until(lambda: "own" in heard)
    handler.remove_parameter_callback(of_speed)
    handler.remove_parameter_event_callback(of_all)
    with pytest.raises(UnknownCallbackError):
        handler.remove_parameter_callback(of_speed)
    handler.destroy()
    assert not list(watcher.subscriptions)


def test_callbacks_of_a_handler_are_kept_under_rclpys_names(node: zbot.Node) -> None:
    handler, heard = ParameterEventHandler(node), list[Any]()
    first = handler.add_parameter_callback("speed", "arm", lambda _: heard.append("first"))
    last = handler.add_parameter_callback("speed", "arm", lambda _: heard.append("last"))
    of_all = handler.add_parameter_event_callback(heard.append)
    callbacks = handler._callbacks
    assert callbacks.parameter_callbacks == {("speed", "/lab/arm"): [last, first]}
    assert callbacks.event_callbacks == [of_all]
    event = ParameterEvent(node="/lab/arm", changed_parameters=SPEED)
    callbacks.event_callback(event)
    assert heard == ["last", "first", event]
    handler.remove_parameter_callback(first)
    handler.remove_parameter_callback(last)
    assert not callbacks.parameter_callbacks


def test_an_event_with_parameters_instead_of_messages_is_refused(node: zbot.Node) -> None:
    publisher = node.create_publisher(ParameterEvent, "events", 1)
    with pytest.raises(zbot.ZbotError, match="new_parameters"):
        publisher.publish(ParameterEvent(new_parameters=SPEED))


def test_a_handler_can_be_limited_to_some_nodes(
    node: zbot.Node, make_context: MakeContext, spin: Spin
) -> None:
    watcher = zbot.Node("watcher", context=make_context(), namespace="lab")
    handler = ParameterEventHandler(watcher)
    heard: list[str] = []
    handler.add_parameter_event_callback(lambda event: heard.append(event.node))
    assert handler.configure_nodes_filter(["robot", "/elsewhere"])
    spin(watcher)
    assert wait_until(lambda: node.count_subscribers("/parameter_events") == 1)
    watcher.declare_parameter("speed", 1.0)
    node.declare_parameter("speed", 1.0)
    assert wait_until(lambda: heard == ["/lab/robot"])
    assert handler.configure_nodes_filter()
    watcher.declare_parameter("force", 1.0)
    assert wait_until(lambda: heard == ["/lab/robot", "/lab/watcher"])
