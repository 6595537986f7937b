"""Tests of transforms that are looked up in another node's buffer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.tf2 import Buffer, ConnectivityException, LookupException, TimeoutException
from zbot.tf2.remote_buffer import BufferClient, BufferServer

from geometry_msgs.msg import PointStamped, TransformStamped
from tf2_msgs.action import LookupTransform

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin

LATEST = zbot.Time()
MOMENT = zbot.Duration(seconds=0.05)


def make_transform(parent: str, child: str, seconds: int, x: float) -> TransformStamped:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp.sec = parent, seconds
    message.transform.translation.x, message.transform.rotation.w = x, 1.0
    return message


@pytest.fixture
def buffer() -> Buffer:
    made = Buffer()
    for seconds, x in ((10, 1.0), (12, 3.0)):
        made.set_transform(make_transform("map", "robot", seconds, x), "test")
    made.set_transform(make_transform("moon", "crater", 10, 1.0), "test")
    return made


@pytest.fixture
def client(buffer: Buffer, make_context: MakeContext, spin: Spin) -> BufferClient:
    node = zbot.Node("knowing", context=make_context())
    server = BufferServer(buffer, node, "lookup")
    assert server is not None
    asking = zbot.Node("asking", context=make_context())
    spin(node)
    spin(asking)
    return BufferClient(asking, "lookup")


def test_a_transform_is_that_of_the_other_buffer(client: BufferClient) -> None:
    assert client.wait_for_server(zbot.Duration(seconds=5))
    found = client.lookup_transform("map", "robot", zbot.Time(seconds=11))
    assert found.transform.translation.x == pytest.approx(2.0)
    assert client.can_transform("map", "robot", LATEST)
    point = PointStamped()
    point.header.frame_id, point.header.stamp.sec = "robot", 12
    assert client.transform(point, "map").point.x == pytest.approx(3.0)


def test_two_times_can_be_asked_for(client: BufferClient) -> None:
    earlier, later = zbot.Time(seconds=10), zbot.Time(seconds=12)
    found = client.lookup_transform_full("robot", earlier, "robot", later, "map")
    assert found.transform.translation.x == pytest.approx(2.0)
    assert client.can_transform_full("robot", earlier, "robot", later, "map")
    assert not client.can_transform_full("robot", earlier, "robot", later, "moon")


def test_an_exception_of_the_other_buffer_is_raised_by_the_client(client: BufferClient) -> None:
    with pytest.raises(LookupException, match="nowhere"):
        client.lookup_transform("map", "nowhere", LATEST)
    with pytest.raises(ConnectivityException):
        client.lookup_transform("map", "crater", LATEST, MOMENT)
    assert not client.can_transform("map", "crater", LATEST)


def test_a_missing_server_is_an_error(make_context: MakeContext) -> None:
    node = zbot.Node("asking", context=make_context())
    client = BufferClient(node, "missing", timeout_padding=MOMENT)
    with pytest.raises(TimeoutException, match="no node serves the action missing"):
        client.lookup_transform("map", "robot", LATEST)


def test_the_padding_may_be_seconds(make_context: MakeContext) -> None:
    client = BufferClient(zbot.Node("asking", context=make_context()), "missing", 10.0, 0.01)
    assert not client.can_transform("map", "robot", LATEST)


def test_a_server_without_visible_topics_is_called(make_context: MakeContext, spin: Spin) -> None:
    node = zbot.Node("bare", context=make_context())
    parts = LookupTransform.Impl

    def accept(_: Any, response: Any) -> Any:
        response.accepted = True
        return response

    def answer(_: Any, response: Any) -> Any:
        response.result.transform.child_frame_id = "robot"
        return response

    node.create_service(parts.SendGoalService, "bare/_action/send_goal", accept)
    node.create_service(parts.GetResultService, "bare/_action/get_result", answer)
    spin(node)
    client = BufferClient(zbot.Node("asking", context=make_context()), "bare")
    assert client.lookup_transform("map", "robot", LATEST).child_frame_id == "robot"
