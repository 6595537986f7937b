"""Tests of time sources that a program creates."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

import pytest

import zbot
import zbot.compat  # noqa: F401 - makes rclpy importable
from zbot.errors import WrongValueError
from zbot.executor.clock import Clock, ROSClock
from zbot.node.time_source import TimeSource
from zbot.time import Time

from builtin_interfaces.msg import Time as Stamp
from rosgraph_msgs.msg import Clock as ClockMessage

if TYPE_CHECKING:
    from tests.conftest import MakeContext

NINE_SECONDS = ClockMessage(clock=Stamp(sec=9))


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("timed", context=make_context())


def topics(node: zbot.Node) -> list[str]:
    return [subscription.topic_name for subscription in node.subscriptions]


def test_a_time_source_follows_the_parameter_of_its_node(node: zbot.Node) -> None:
    source, clock = TimeSource(node=node), ROSClock()
    source.attach_clock(clock)
    assert not clock.ros_time_is_active
    node.set_parameters([zbot.Parameter("use_sim_time", value=True)])
    assert source.ros_time_is_active
    assert topics(node).count("/clock") == 2  # the node's own time source has one too
    source.clock_callback(NINE_SECONDS)
    assert clock.now().nanoseconds == 9_000_000_000
    source.detach_node()
    assert topics(node).count("/clock") == 1
    node.set_parameters([zbot.Parameter("use_sim_time", value=False)])
    assert clock.ros_time_is_active


def test_a_clock_attached_later_gets_the_last_time(node: zbot.Node) -> None:
    source, clock = TimeSource(), ROSClock()
    source.ros_time_is_active = True
    source.clock_callback(NINE_SECONDS)
    source.attach_clock(clock)
    assert clock.now() == Time(seconds=9, clock_type=clock.clock_type)
    source.attach_node(node)
    assert not clock.ros_time_is_active


def test_the_time_source_attached_last_is_updated_first(node: zbot.Node) -> None:
    # A program that spins once per message of `/clock` sees its own clock change.
    source = TimeSource(node=node)
    node.set_parameters([zbot.Parameter("use_sim_time", value=True)])
    first = next(
        subscription for subscription in node.subscriptions if subscription.topic_name == "/clock"
    )
    assert first is source._clock_sub
    assert source._get_node() is node


def test_a_callback_may_sleep_in_simulated_time(make_context: MakeContext) -> None:
    context = make_context()
    node = zbot.Node("timed", context=context, cli_args=["--ros-args", "-p", "use_sim_time:=true"])
    done: zbot.Future[None] = zbot.Future()

    async def pause() -> None:
        timer = node.create_timer(8.0, lambda: done.set_result(None), zbot.ReentrantCallbackGroup())
        node.create_publisher(ClockMessage, "/clock", 1).publish(NINE_SECONDS)
        await done
        node.destroy_timer(timer)

    with zbot.SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        node.create_guard_condition(pause).trigger()
        executor.spin_until_future_complete(done, 5)
    assert done.done()


def test_only_clocks_of_ros_time_can_be_attached() -> None:
    wrong: Any = Clock()
    with pytest.raises(WrongValueError):
        TimeSource().attach_clock(wrong)


def test_the_type_description_service_of_a_node_can_be_destroyed(node: zbot.Node) -> None:
    service = importlib.import_module("rclpy.type_description_service").TypeDescriptionService
    names = [known.srv_name for known in node.services]
    own = service(node)
    assert own.enabled
    assert own.service_name == "/timed/get_type_description"
    own.destroy()
    own.destroy()
    assert [known.srv_name for known in node.services] == names
