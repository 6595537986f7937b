"""Tests of messages that mix classes of zbot and of a genuine ROS 2 in one process."""

from __future__ import annotations

import subprocess

from tests.integration.bridge.conftest import PYTHON, needs_ros2

pytestmark = needs_ros2()

PROGRAM = """
import copy, pickle
import zbot
from zbot.interfaces import get_message
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.messagepack.codec import messagepack_codec_for
from geometry_msgs.msg import Pose, PoseArray
from std_msgs.msg import Header

OwnArray = get_message("geometry_msgs/msg/PoseArray")
OwnPose, OwnPoint = (get_message(f"geometry_msgs/msg/{name}") for name in ("Pose", "Point"))
OwnHeader, OwnTime = get_message("std_msgs/msg/Header"), get_message("builtin_interfaces/msg/Time")
assert not issubclass(OwnHeader, Header)

own = OwnArray(header=Header(frame_id="map"), poses=[Pose(), OwnPose()])
own.poses[0].position = OwnPoint(x=2.0)
genuine = PoseArray(header=OwnHeader(frame_id="map", stamp=OwnTime(sec=3)), poses=[OwnPose()])
for message in (own, genuine):
    for codec_for in (messagepack_codec_for, cdr_codec_for):
        codec = codec_for(type(message))
        assert str(codec.decode(codec.encode(message))) == str(message)
assert str(pickle.loads(pickle.dumps(own))) == str(copy.deepcopy(own)) == str(own)

from unique_identifier_msgs.msg import UUID
from action_msgs.srv import CancelGoal

goal = CancelGoal.Request()
goal.goal_info.goal_id = get_message("unique_identifier_msgs/msg/UUID")(uuid=[7] * 16)
goal.goal_info.stamp = OwnTime(sec=1)
codec = messagepack_codec_for(CancelGoal.Request)
assert codec.decode(codec.encode(goal)).goal_info.goal_id == UUID(uuid=[7] * 16)
print("mixed")
"""


def test_classes_of_both_mix_in_any_depth() -> None:
    done = subprocess.run(
        [PYTHON, "-c", PROGRAM], capture_output=True, text=True, timeout=120, check=False
    )
    assert (done.stdout, done.stderr) == ("mixed\n", "")
