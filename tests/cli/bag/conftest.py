"""Fixtures of the tests of `zbot bag`."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import pytest

import zbot as library
from tests.cli.bag.programs import Robot
from zbot.qos import DurabilityPolicy, QoSProfile

from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin


@pytest.fixture
def robot(make_context: MakeContext, spin: Spin) -> Robot:
    robot = Robot(library.Node("robot", context=make_context()))
    spin(robot.node)
    return robot


@pytest.fixture
def bag(tmp_path: Path) -> Path:
    return tmp_path / "lesson"


@pytest.fixture
def heard(make_context: MakeContext, spin: Spin) -> list[tuple[str, str, float]]:
    """Return a list that fills with the topic, the text and the time of each message."""
    found: list[tuple[str, str, float]] = []
    node = library.Node("ear", context=make_context())
    for topic in ("/a", "/b", "/renamed"):
        node.create_subscription(
            String,
            topic,
            lambda message, name=topic: found.append((name, message.data, time.perf_counter())),
            QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL),
        )
    spin(node)
    return found
