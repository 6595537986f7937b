"""Checks of launch tests for robots with controllers: `controller_manager.test_utils` of ROS 2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.testing.topics import WaitForTopics
from zbot.libraries.controller_manager import list_controllers
from zbot.threads.deadline import poll

from sensor_msgs.msg import JointState

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.node.node import Node

_PERIOD_S = 0.1
_MANAGER_S = 5.0  # how long to wait for the controller manager
_JOINTS_S = 20.0  # how long to wait for a joint state


def check_node_running(node: Node, node_name: str, timeout: float = 5.0) -> None:
    """Wait until a node is in the graph.

    Raises:
        AssertionError: It was not there within `timeout` seconds.
    """
    if not poll(lambda: node_name in node.get_node_names(), timeout, _PERIOD_S):
        raise AssertionError(f"{node_name} not found!")


def check_controllers_running(
    node: Node,
    cnames: Sequence[str],
    namespace: str = "",
    state: str = "active",
    timeout: float = 10.0,
) -> None:
    """Wait until controllers have a state.

    Args:
        node: The node that asks. No other thread may spin it.
        cnames: The controllers.
        namespace: The namespace of the controller manager.
        state: `unconfigured`, `inactive` or `active`.
        timeout: How long to wait, in seconds.

    Raises:
        AssertionError: A controller does not have the state in time.
    """
    space = namespace.strip("/")
    manager = f"/{space}/controller_manager" if space else "/controller_manager"
    states: dict[str, str] = {}

    def have_state() -> bool:
        found = list_controllers(node, manager, _MANAGER_S).controller
        states.update((controller.name, controller.state) for controller in found)
        return all(states.get(name) == state for name in cnames)

    if not poll(have_state, timeout, _PERIOD_S):
        wrong = ", ".join(name for name in cnames if states.get(name) != state)
        raise AssertionError(f"Controller(s) not found or not {state}: {wrong}; there are {states}")


def check_if_js_published(topic: str, joint_names: Sequence[str]) -> None:
    """Wait for a joint state, and compare its joints.

    Raises:
        AssertionError: No message came within 20 seconds, or it has other joints.
    """
    with WaitForTopics([(topic, JointState)], timeout=_JOINTS_S) as topics:
        found = topics.received_messages(topic)[0].name
    if sorted(found) != sorted(joint_names):
        raise AssertionError(f"Wrong joint names: {list(found)} instead of {list(joint_names)}")
