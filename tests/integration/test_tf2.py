"""Tests of transforms between sessions: broadcasters, listeners and waiting lookups."""

from __future__ import annotations

import importlib
import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed, wait_until
from zbot.tf2 import (
    Buffer,
    LookupException,
    StaticTransformBroadcaster,
    StaticTransformListener,
    TransformBroadcaster,
    TransformListener,
    TypeException,
)
from zbot.tf2.diagnosis import TransformMonitor

from geometry_msgs.msg import PointStamped, PoseStamped, TransformStamped
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from tf2_msgs.srv import FrameGraph

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from zbot.log.record import Record

NOW = zbot.Time()
PATIENCE = zbot.Duration(seconds=10)


def make_transform(parent: str, child: str, x: float = 1.0) -> TransformStamped:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = zbot.Clock().now().to_msg()
    message.transform.translation.x = x
    return message


@pytest.fixture
def robot(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("robot", context=make_context())


@pytest.fixture
def watcher(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("watcher", context=make_context())


def test_a_listener_receives_dynamic_and_static_transforms(
    robot: zbot.Node, watcher: zbot.Node, spin: Spin
) -> None:
    StaticTransformBroadcaster(robot).sendTransform(
        [make_transform("base", "laser"), make_transform("base", "imu")]
    )
    buffer = Buffer()
    listener = TransformListener(buffer, watcher)
    spin(watcher)
    TransformBroadcaster(robot).sendTransform(make_transform("map", "base"))
    assert buffer.can_transform("map", "laser", NOW, PATIENCE)
    found = buffer.lookup_transform("map", "imu", NOW)
    assert found.transform.translation.x == 2
    listener.unregister()
    listener.unregister()


def test_a_static_listener_receives_only_static_transforms(
    robot: zbot.Node, watcher: zbot.Node, spin: Spin
) -> None:
    moving = TransformBroadcaster(robot)
    StaticTransformBroadcaster(robot).sendTransform(make_transform("base", "laser"))
    buffer = Buffer()
    listener = StaticTransformListener(buffer, watcher)
    spin(watcher)
    assert moving.pub_tf.get_subscription_count() == 0
    assert buffer.can_transform("base", "laser", NOW, PATIENCE)
    listener.unregister()


def test_static_transforms_accumulate(robot: zbot.Node, watcher: zbot.Node) -> None:
    broadcaster = StaticTransformBroadcaster(robot)
    broadcaster.sendTransform(make_transform("base", "laser"))
    broadcaster.sendTransform(make_transform("base", "imu"))
    buffer = Buffer()
    TransformListener(buffer, watcher, spin_thread=True)
    assert buffer.can_transform("laser", "imu", NOW, PATIENCE)


def test_a_message_may_be_reused_after_sending(robot: zbot.Node, watcher: zbot.Node) -> None:
    broadcaster = StaticTransformBroadcaster(robot)
    message = make_transform("base", "laser")
    broadcaster.sendTransform(message)
    message.child_frame_id = "imu"
    broadcaster.sendTransform(message)
    buffer = Buffer()
    TransformListener(buffer, watcher, spin_thread=True)
    assert buffer.can_transform("laser", "imu", NOW, PATIENCE)


def test_a_jump_back_clears_dynamic_transforms(watcher: zbot.Node, logged: list[Record]) -> None:
    buffer = Buffer()
    listener = TransformListener(buffer, watcher)
    clock: Any = watcher.get_clock()
    clock.set_ros_time_is_active(True)
    clock.set_ros_time_override(zbot.Time(seconds=100))
    buffer.set_transform(make_transform("map", "base"))
    clock.set_ros_time_override(zbot.Time(seconds=101))
    assert buffer.can_transform("map", "base", NOW)
    clock.set_ros_time_override(zbot.Time(seconds=1))
    assert not buffer.can_transform("map", "base", NOW)
    assert any("jump back in time" in record.message for record in logged)
    listener.unregister()


def test_waiting_ends_at_shutdown(watcher: zbot.Node) -> None:
    buffer = Buffer()
    TransformListener(buffer, watcher, spin_thread=True)
    outcomes: list[Any] = []
    wait = zbot.Duration(seconds=30)
    thread = threading.Thread(
        target=lambda: outcomes.append(buffer.can_transform("map", "base", NOW, wait))
    )
    thread.start()
    watcher.context.shutdown()
    thread.join(5)
    assert outcomes == [False]


def test_waiting_for_a_transform_ends_with_its_error(watcher: zbot.Node) -> None:
    buffer = Buffer()
    TransformListener(buffer, watcher, spin_thread=True)
    begun = time.monotonic()
    with pytest.raises(LookupException):
        buffer.lookup_transform("map", "base", NOW, zbot.Duration(seconds=0.1))
    assert 0.1 <= time.monotonic() - begun < allowed(1)


@pytest.mark.parametrize("is_there", [True, False])
def test_a_callback_may_wait_for_a_transform_of_its_own_executor(
    robot: zbot.Node, watcher: zbot.Node, spin: Spin, is_there: bool
) -> None:
    buffer = Buffer()
    TransformListener(buffer, watcher)
    outcomes: list[Any] = []

    def look() -> None:
        timer.cancel()
        wait = PATIENCE if is_there else zbot.Duration(seconds=0.1)
        outcomes.append(buffer.can_transform("map", "base", NOW, wait))

    broadcaster = TransformBroadcaster(robot)
    if is_there:
        threading.Timer(0.1, broadcaster.sendTransform, [make_transform("map", "base")]).start()
    timer = watcher.create_timer(0.001, look)
    spin(watcher)
    assert wait_until(lambda: bool(outcomes))
    assert outcomes == [is_there]


def test_a_coroutine_waits_for_a_transform(
    robot: zbot.Node, watcher: zbot.Node, spin: Spin
) -> None:
    buffer = Buffer()
    TransformListener(buffer, watcher)
    found: list[float] = []

    async def look(_: String) -> None:
        seen = await buffer.lookup_transform_async("map", "base", NOW)
        found.append(seen.transform.translation.x)

    watcher.create_subscription(String, "go", look, 10)
    spin(watcher)
    robot.create_publisher(String, "go", 10).publish(String())
    TransformBroadcaster(robot).sendTransform(make_transform("map", "base", 3.0))
    assert wait_until(lambda: found == [3.0])


def test_points_and_poses_change_frames() -> None:
    buffer = Buffer()
    buffer.set_transform_static(make_transform("map", "base", 5.0))
    point = PointStamped()
    point.header.frame_id = "base"
    point.point.y = 2.0
    moved = buffer.transform(point, "map")
    assert (moved.header.frame_id, moved.point.x, moved.point.y) == ("map", 5.0, 2.0)
    pose = PoseStamped()
    pose.header.frame_id = "map"
    assert buffer.transform(pose, "base").pose.position.x == -5
    with pytest.raises(TypeException, match="String"):
        buffer.transform(String(), "map")


def test_a_buffer_with_a_node_has_the_service_tf2_frames(
    robot: zbot.Node, watcher: zbot.Node, spin: Spin
) -> None:
    buffer = Buffer(node=watcher)
    buffer.set_transform_static(make_transform("base", "laser"))
    spin(watcher)
    client = robot.create_client(FrameGraph, "tf2_frames")
    assert client.wait_for_service(5)
    answer = client.call(FrameGraph.Request(), timeout_sec=5)
    assert answer is not None
    assert answer.frame_yaml == buffer.all_frames_as_yaml()
    assert "parent: 'base'" in answer.frame_yaml


def test_the_topics_of_a_listener_have_names() -> None:
    transform_listener = importlib.import_module("tf2_ros.transform_listener")
    assert transform_listener.DEFAULT_TF_TOPIC == "/tf"
    assert transform_listener.DEFAULT_STATIC_TF_TOPIC == "/tf_static"


def test_a_monitor_hears_namespaces_and_follows_the_rules_of_its_node(
    robot: zbot.Node, make_context: MakeContext, spin: Spin
) -> None:
    rules = ["--ros-args", "-r", "/tf:=/robot1/tf", "-r", "/tf_static:=/robot1/tf_static"]
    watcher = zbot.Node("watcher", context=make_context(), cli_args=rules)
    monitor = TransformMonitor(watcher)
    StaticTransformBroadcaster(robot).sendTransform(make_transform("map", "odom"))
    other = robot.create_publisher(TFMessage, "/robot2/tf", 10)
    timer = robot.create_timer(
        0.05, lambda: other.publish(TFMessage(transforms=[make_transform("odom", "base")]))
    )
    spin(robot)
    spin(watcher)
    diagnosis = monitor.diagnosis
    assert wait_until(lambda: bool(diagnosis.links("/robot2/tf")), 10)
    assert diagnosis.topics == ["/robot1/tf", "/robot2/tf"]
    (link,) = diagnosis.links("/robot2/tf")
    assert link.nodes == ["/robot"]
    count = len(monitor.buffer.subscriptions)
    monitor.look()
    assert len(monitor.buffer.subscriptions) == count
    reason = monitor.explanation("odom", "base")
    assert "`odom` and `base` are on /robot2/tf, and the program hears /robot1/tf" in reason
    timer.cancel()
    monitor.unregister()
    assert monitor.buffer.subscriptions == []
