"""The panel Joints finds the nodes with sliders, and the joints without one."""

from __future__ import annotations

import math

import pytest

from tests.unit.tokens import endpoint_token
from zbot.graph.snapshot import Snapshot
from zbot.web.panels.joints.other_joints import other_joints
from zbot.web.panels.joints.slider_nodes import slider_nodes, states_topic
from zbot.wire.tokens import EndpointToken, EntityKind

from sensor_msgs.msg import JointState

EMPTY = "std_srvs/srv/Empty"


def server(name: str, type_name: str = EMPTY) -> EndpointToken:
    return endpoint_token(name, kind=EntityKind.SERVICE, type_name=type_name)


@pytest.mark.parametrize(
    ("servers", "nodes"),
    [
        ([], []),
        ([server("/a/center"), server("/a/randomize")], ["/a"]),
        (
            [server(f"/{robot}/gui/{name}") for robot in "ba" for name in ("center", "randomize")],
            ["/a/gui", "/b/gui"],
        ),
        ([server("/a/center")], []),
        ([server("/a/center", "std_srvs/srv/Trigger"), server("/a/randomize")], []),
        ([server("/center"), server("/randomize")], []),
        ([server("/_a/center"), server("/_a/randomize")], []),
    ],
)
def test_a_node_with_sliders_has_both_services(
    servers: list[EndpointToken], nodes: list[str]
) -> None:
    assert slider_nodes(Snapshot(tuple(servers))) == nodes


def test_the_topic_is_the_one_of_this_node() -> None:
    def publisher(topic: str, node: str, type_name: str) -> EndpointToken:
        return endpoint_token(
            topic, kind=EntityKind.PUBLISHER, namespace="/", node=node, type_name=type_name
        )

    states = "sensor_msgs/msg/JointState"
    graph = Snapshot(
        (
            publisher("/other", "driver", states),
            publisher("/rosout", "gui", "rcl_interfaces/msg/Log"),
            publisher("/states", "gui", states),
        )
    )
    assert states_topic(graph, "/gui") == "/states"
    assert states_topic(graph, "/nobody") is None


def test_joints_without_a_slider_have_a_line() -> None:
    message = JointState(name=["a", "b", "c", "d"], position=[1.0, -0.5, math.nan])
    assert other_joints(message, ["a"]) == ["b follows: -0.500"]
    assert other_joints(message, []) == []
    assert other_joints(None, ["a"]) == []
