"""Robot descriptions that Gazebo's programs for spawning read from files and topics."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import zbot
from zbot.qos import DurabilityPolicy, QoSProfile

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_SAY_PERIOD_S = 5.0


def from_topic(node: zbot.Node, topic: str) -> str:
    """Return the first text on a topic."""
    texts: list[str] = []
    subscription = node.create_subscription(
        String, topic, lambda message: texts.append(message.data), _KEPT
    )
    wait_until(node, lambda: bool(texts), f"messages on the topic {topic}")
    node.destroy_subscription(subscription)
    return texts[0]


def from_file(path: str) -> str:
    """Return the text of a file.

    Raises:
        SystemExit: The file cannot be read.
    """
    try:
        return Path(path).read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        sys.exit(f"error: the file {path} cannot be read: {error}")


def from_models(name: str) -> str:
    """Return the description of a model of this machine.

    Raises:
        SystemExit: There is no such model, or its file cannot be read.
    """
    from zbot.simulation.sdf.document import model_file  # noqa: PLC0415 - seldom used
    from zbot.simulation.sdf.resources import find_resource  # noqa: PLC0415 - as above

    folder = find_resource(f"model://{name}")
    file = None if folder is None else model_file(folder)
    if file is None:
        sys.exit(
            f"error: there is no model '{name}' on this machine: put its folder into "
            "~/.gazebo/models, or add the folder above it to GAZEBO_MODEL_PATH"
        )
    return from_file(str(file))


def wait_until(node: zbot.Node, condition: Callable[[], bool], what: str) -> None:
    """Handle messages until a condition holds. Say every few seconds what is awaited."""
    node.get_logger().info(f"Waiting for {what}")
    while not condition():
        zbot.spin_once(node, timeout_sec=0.05)
        node.get_logger().info(
            f"Still waiting for {what}", throttle_duration_sec=_SAY_PERIOD_S, skip_first=True
        )
