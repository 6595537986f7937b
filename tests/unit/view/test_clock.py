"""The view takes the time of `/clock` while a node publishes it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from zbot.executor.spin_thread import SpinThread
from zbot.view.clock import ViewClock

from rosgraph_msgs.msg import Clock

if TYPE_CHECKING:
    from tests.conftest import MakeContext


def clock_message(seconds: int) -> Clock:
    message = Clock()
    message.clock.sec = seconds
    return message


@pytest.mark.parametrize("is_automatic", [True, False])
def test_the_time_comes_from_the_clock_topic(make_context: MakeContext, is_automatic: bool) -> None:
    context = make_context()
    node = zbot.Node("viewer", context=context)
    simulator = zbot.Node("simulator", context=context)
    spinner = SpinThread(node, "test")
    clock = ViewClock(node, is_automatic=is_automatic)
    wall_ns = clock.now_ns()
    assert not clock.has_jumped_back()
    publisher = simulator.create_publisher(Clock, "/clock", 10)
    clock.look(context.graph.snapshot())
    assert node.get_parameter("use_sim_time").value is is_automatic
    if not is_automatic:
        assert clock.now_ns() >= wall_ns
        spinner.stop()
        return
    assert not clock.has_jumped_back()
    for seconds, has_jumped in ((7, False), (8, False), (2, True), (3, False)):

        def is_there(seconds: int = seconds) -> bool:
            publisher.publish(clock_message(seconds))
            return clock.now_ns() == seconds * 10**9

        assert wait_until(is_there, 10)
        assert clock.has_jumped_back() is has_jumped
    simulator.destroy_publisher(publisher)
    clock.look(context.graph.snapshot())
    assert clock.now_ns() >= wall_ns
    spinner.stop()
