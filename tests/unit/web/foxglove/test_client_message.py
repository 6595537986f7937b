"""Tests of the messages that a client of the server for Foxglove sends."""

from __future__ import annotations

import math

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.web.foxglove.publishing import client_message

from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import LaserScan
from std_msgs.msg import UInt8MultiArray
from tf2_msgs.msg import TFMessage


def test_json_is_read_as_rosbridge_reads_it() -> None:
    assert bytes(client_message(b'{"data": "AAH/"}', UInt8MultiArray, "json").data) == b"\0\1\xff"
    ranges = client_message(b'{"ranges": [1, null]}', LaserScan, "json").ranges
    assert ranges[0] == 1.0
    assert math.isnan(ranges[1])


def test_a_header_without_a_stamp_keeps_its_default() -> None:
    message = client_message(b'{"header": {"frame_id": "map"}}', PoseStamped, "json")
    assert (message.header.stamp.sec, message.header.frame_id) == (0, "map")


def test_a_wrong_value_is_named_with_its_path() -> None:
    with pytest.raises(FieldMisfitError, match=r"^pose\.position\.x must be a float, not 'a'$"):
        client_message(b'{"pose": {"position": {"x": "a"}}}', PoseStamped, "json")


def test_a_text_cannot_stand_for_much_more_memory() -> None:
    data = b'{"transforms": [' + b"{}," * 100_000 + b"{}]}"
    with pytest.raises(FieldMisfitError, match="messages in transforms leave out too many values"):
        client_message(data, TFMessage, "json")
    data = b'{"transforms": [' + b"{}," * 1_000 + b"{}]}"
    assert len(client_message(data, TFMessage, "json").transforms) == 1_001
