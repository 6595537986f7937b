"""How programs of a domain find the page that shows it already, to use it and start no second."""

from __future__ import annotations

import json
import socket
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_message
from zbot.node.wait_for_message import wait_for_message
from zbot.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from zbot.node.node import Node

#: Hidden, and latched: who comes later gets it too.
TOPIC = "/_zbot_web"
_TYPE = "std_msgs/msg/String"
_LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_PATIENCE_S = 2.0


def announce(node: Node, address: str) -> None:
    """Tell the domain that a page can be had, until the node ends.

    Args:
        node: Publishes it.
        address: Where, without a path: `http://127.0.0.1:8080`. An address with a token in it is
            nobody else's business.
    """
    message_type: Any = get_message(_TYPE)
    facts = {"host": socket.gethostname(), "address": address}
    node.create_publisher(message_type, TOPIC, _LATCHED).publish(
        message_type(data=json.dumps(facts))
    )


def running_page(node: Node) -> str | None:
    """Return the address of a page of this machine that shows the node's domain; None if none does.

    Args:
        node: Asks; a node that nobody spins yet.
    """
    if not node.count_publishers(TOPIC):
        return None
    message_type: Any = get_message(_TYPE)
    came, message = wait_for_message(
        message_type, node, TOPIC, qos_profile=_LATCHED, time_to_wait=_PATIENCE_S
    )
    if not came or message is None:
        return None
    facts = json.loads(message.data)
    return str(facts["address"]) if facts["host"] == socket.gethostname() else None
