"""Advice about problems of transforms: what to type."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.tf2.diagnosis.link import Link

_SIM_TIME = "--ros-args -p use_sim_time:=true"
_LOOKUP = "buffer.lookup_transform(target, source, stamp, timeout=Duration(seconds=1.0))"


def who(link: Link) -> str:
    """Return the nodes that publish a link, and its topic, e.g. `/driver on /tf`."""
    return f"{' and '.join(link.nodes) or 'a node'} on {link.topic}"


def publish_static(parent: str, child: str) -> str:
    """Return the command that publishes a link that does not change."""
    return (
        f"zbot run tf2_ros static_transform_publisher --frame-id {parent} --child-frame-id {child}"
    )


def connect(parent: str, child: str) -> str:
    """Return how to get a link between two frames."""
    command = publish_static(parent, child)
    above, name = parent.rpartition("/")[2], child.rpartition("/")[2]
    if (above, name) == ("map", "odom"):
        return f"start the node that finds the robot in the map (AMCL or SLAM), or try: {command}"
    if name in {"base_link", "base_footprint"}:
        return f"start the node that publishes the robot's odometry, or try: {command}"
    return f"if `{child}` is fixed to `{parent}`, type: {command}"


def start_robot(topic: str) -> str:
    """Return what to start if nobody publishes transforms."""
    return f"start the robot, then look who publishes: zbot topic info -v {topic}"


def wake(nodes: Sequence[str]) -> str:
    """Return what to do about nodes that have a publisher, but are silent."""
    several = "they have sent" if len(nodes) > 1 else "it has sent"
    return f"look at the output of {' and '.join(nodes)}: {several} no transform yet"


def remap(topic: str) -> str:
    """Return how to hear the transforms of a namespace."""
    prefix = topic.removesuffix("/tf")
    return (
        f"start the program with: --ros-args -r /tf:={prefix}/tf -r /tf_static:={prefix}/tf_static"
        f"; or copy them: zbot run topic_tools relay {prefix}/tf /tf, and the same for tf_static"
    )


def look_at(nodes: Iterable[str]) -> str:
    """Return the commands that show what nodes publish."""
    return "; ".join(f"zbot node info {name}" for name in nodes)


def start_again(nodes: Sequence[str]) -> str:
    """Return what to do about nodes that have ended."""
    return f"start {' and '.join(nodes)} again"


def look_at_output(link: Link) -> str:
    """Return what to do about a link that has stopped."""
    nodes = " and ".join(link.nodes) or "its node"
    return f"look at the output of {nodes}, and what comes: zbot topic hz {link.topic}"


def use_sim_time(nodes: Sequence[str]) -> str:
    """Return how nodes get simulated time."""
    if not nodes:
        return f"start all nodes with the same time, for a simulation with: {_SIM_TIME}"
    commands = "; ".join(f"zbot param set {name} use_sim_time true" for name in nodes)
    return f"{commands}; or start with: {_SIM_TIME}"


def set_clock(topic: str) -> str:
    """Return what to do about a wrong clock.

    Args:
        topic: The topic of the messages with wrong stamps, or nothing for transforms.
    """
    return (
        "set the clocks of both machines by the network (on Linux: sudo timedatectl set-ntp true), "
        f"then measure again: {f'zbot topic delay {topic}' if topic else 'zbot doctor --tf'}"
    )


def stamp_now() -> str:
    """Return what to do about stamps in the future."""
    return (
        "stamp with self.get_clock().now(); a node such as AMCL stamps ahead on purpose "
        "(transform_tolerance)"
    )


def wait_for(link: Link) -> str:
    """Return how a program gets a transform that has not come yet."""
    if link.rate_hz:
        often = f"it comes {link.rate_hz:.0f} times a second" if link.rate_hz >= 1 else "it is slow"
        return f"wait for it ({often}): {_LOOKUP}"
    return f"wait for it: {_LOOKUP}"


def measure_delay(topic: str) -> str:
    """Return what to do about messages that are older than the known transforms."""
    return (
        "wait some seconds, because older transforms are unknown; if it stays so, see how old the "
        f"messages are: zbot topic delay {topic or 'TOPIC'}"
    )
