"""Tests of `wait_for_all_acked()` of publishers."""

from __future__ import annotations

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.conftest import KEEP_ALL, await_match
from zbot.qos import QoSProfile, ReliabilityPolicy

from std_msgs.msg import String

BEST_EFFORT = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)


def test_messages_to_another_session_are_not_known_to_be_acknowledged(
    talker: zbot.Node, listener: zbot.Node
) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    listener.create_subscription(String, "chatter", print, 10)
    await_match(publisher)
    assert publisher.wait_for_all_acked(zbot.Duration(seconds=1))  # nothing was published
    publisher.publish(String(data="hi"))
    assert not publisher.wait_for_all_acked(zbot.Duration(seconds=1))
    assert not publisher.wait_for_all_acked()
    listener.destroy_node()
    await_match(publisher, 0)
    assert publisher.wait_for_all_acked()


@pytest.mark.parametrize(
    ("offered", "requested"), [(BEST_EFFORT, KEEP_ALL), (KEEP_ALL, BEST_EFFORT)]
)
def test_best_effort_needs_no_acknowledgement(
    offered: QoSProfile, requested: QoSProfile, talker: zbot.Node, listener: zbot.Node
) -> None:
    publisher = talker.create_publisher(String, "chatter", offered)
    listener.create_subscription(String, "chatter", print, requested)
    await_match(publisher)
    publisher.publish(String(data="hi"))
    assert publisher.wait_for_all_acked()


def test_a_subscription_of_the_same_context_acknowledges_at_once(talker: zbot.Node) -> None:
    subscription = talker.create_subscription(String, "chatter", print, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    await_match(publisher)
    publisher.publish(String(data="hi"))
    assert publisher.wait_for_all_acked()
    assert wait_until(lambda: subscription.has_work, timeout_s=2)
