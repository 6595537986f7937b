"""Tests of what broadcasters say about transforms that listeners ignore."""

from __future__ import annotations

import math
from typing import Any
from unittest.mock import Mock

import pytest

from zbot.tf2 import StaticTransformBroadcaster, TransformBroadcaster

from geometry_msgs.msg import Transform, TransformStamped

Broadcaster = type[TransformBroadcaster] | type[StaticTransformBroadcaster]
BOTH = [TransformBroadcaster, StaticTransformBroadcaster]


def make_transform(parent: str, child: str, x: float = 0.0, w: float = 1.0) -> TransformStamped:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.transform.translation.x, message.transform.rotation.w = x, w
    return message


def warnings(node: Mock) -> list[str]:
    return [call.args[0] for call in node.get_logger().warning.call_args_list]


@pytest.mark.parametrize("broadcaster", BOTH)
@pytest.mark.parametrize(
    ("transform", "sentence"),
    [
        (make_transform("odom", "base", w=0.0), "not a quaternion of length 1"),
        (make_transform("odom", "base", w=5.0), "write rotation.w = 1.0"),
        (make_transform("odom", "base", x=math.nan), "infinite or NaN"),
        (make_transform("odom", ""), "child_frame_id must not be empty"),
        (make_transform("odom", "odom"), "'odom' cannot be its own parent"),
    ],
)
def test_a_transform_that_listeners_ignore_is_sent_and_told_once(
    broadcaster: Broadcaster, transform: TransformStamped, sentence: str
) -> None:
    node = Mock()
    sender = broadcaster(node)
    for _ in range(3):
        sender.sendTransform([transform, make_transform("odom", "arm")])
    assert sender.pub_tf.publish.call_count == 3
    (line,) = warnings(node)
    assert line.startswith("listeners ignore a transform of this node: ")
    assert sentence in line


@pytest.mark.parametrize("broadcaster", BOTH)
def test_only_stamped_transforms_are_sent(broadcaster: Broadcaster) -> None:
    wrong: Any = Transform()
    with pytest.raises(TypeError, match=r"must be a geometry_msgs/msg/TransformStamped, not Tran"):
        broadcaster(Mock()).sendTransform(wrong)
