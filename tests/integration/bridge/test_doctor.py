"""Tests of what `zbot doctor` says about bridges."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tests.integration.bridge.conftest import eventually, needs_ros2

if TYPE_CHECKING:
    from tests.conftest import Start
    from tests.integration.bridge.conftest import Bridges, Peers

pytestmark = needs_ros2()


def test_doctor_looks_at_the_bridge(peer: Peers, bridge: Bridges, start: Start) -> None:
    def told() -> str:
        program = start("zbot", "doctor")
        program.wait(30)
        return program.output

    assert "bridge:" not in told()
    bridge()
    assert eventually(lambda: "WARN  bridge: topics and services: 0, nodes of ROS 2: 0" in told())
    peer().advertise(topic="/pose", type="std_msgs/msg/String")
    assert eventually(lambda: "ok    bridge: topics and services: 1, nodes of ROS 2: 1" in told())
