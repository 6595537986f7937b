"""Tests that use each member of clocks and timers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import rclpy
from rclpy.clock import JumpThreshold, ROSClock
from rclpy.duration import Duration
from rclpy.time import Time

from tests.unit.compat.rclpy_calls.conftest import InUse, ignore, made

from rosgraph_msgs.msg import Clock as ClockMessage

if TYPE_CHECKING:
    from rclpy.node import Node

    from tests.conftest import Spin


def test_clocks(node: Node) -> None:
    clock = InUse("rclpy.clock.Clock", node.get_clock())
    now = clock.now()
    assert clock.sleep_for(Duration(nanoseconds=1), node.context)
    assert clock.sleep_until(now, node.context)
    threshold = JumpThreshold(min_forward=None, min_backward=None, on_clock_change=True)
    jumps: list[object] = []
    made = clock.create_jump_callback(threshold, post_callback=jumps.append)
    handle = InUse("rclpy.clock.JumpHandle", made)
    simulated = InUse("rclpy.clock.ROSClock", ROSClock())
    assert not simulated.ros_time_is_active
    simulated.set_ros_time_override(Time(seconds=5, clock_type=simulated.entity.clock_type))
    handle.unregister()
    assert clock.clock_type.name == "ROS_TIME"
    with clock.handle:
        pass


def test_times_and_durations() -> None:
    time = InUse("rclpy.time.Time", Time(seconds=1, nanoseconds=5))
    assert time.seconds_nanoseconds() == (1, 5)
    assert (time.nanoseconds, time.to_msg().nanosec) == (1_000_000_005, 5)
    assert time.clock_type.name == "SYSTEM_TIME"
    duration = InUse("rclpy.duration.Duration", Duration(seconds=1))
    assert (duration.nanoseconds, duration.to_msg().sec) == (10**9, 1)
    steady = rclpy.clock.ClockType.STEADY_TIME
    times = {"expected_call_time": 5, "actual_call_time": 7}
    info = made("rclpy.timer.TimerInfo", **times, clock_type=steady)
    for name, nanoseconds in times.items():
        assert getattr(info, name) == Time(nanoseconds=nanoseconds, clock_type=steady)


def test_timers_and_rates(node: Node, spin: Spin) -> None:
    timer = InUse("rclpy.timer.Timer", node.create_timer(100.0, ignore))
    assert not timer.is_ready()
    assert timer.time_until_next_call() > 0
    assert timer.time_since_last_call() >= 0
    assert timer.timer_period_ns == 100 * 10**9
    assert timer.clock.clock_type.name
    timer.cancel()
    assert timer.is_canceled()
    timer.reset()
    with timer.handle:
        pass
    timer.destroy()
    spin(node)
    rate = InUse("rclpy.timer.Rate", node.create_rate(1000.0))
    rate.sleep()
    rate.destroy()


def test_time_sources(node: Node) -> None:
    source = made("rclpy.time_source.TimeSource")
    source.attach_node(node)
    source.attach_clock(ROSClock())
    source.clock_callback(ClockMessage())
    assert not source.ros_time_is_active
    source.detach_node()
    made("rclpy.type_description_service.TypeDescriptionService", node).destroy()
