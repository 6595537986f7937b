"""Discovery of a domain's running page, so that a program does not start a second page."""

from __future__ import annotations

import json
import re
import socket
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_message
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.remote.wait_for_message import wait_for_message
from zbot.text.json_reader import JsonError, read_json_object

if TYPE_CHECKING:
    from zbot.node.node import Node

#: Hidden topic. It is latched (transient local), so that later nodes receive the address too.
TOPIC = "/_zbot_web"
_TYPE = "std_msgs/msg/String"
_LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_PATIENCE_S = 2.0
_ADDRESS = re.compile(r"https?://[^\s/]+", re.ASCII)


def announce(node: Node, address: str) -> None:
    """Publish the address of a page in the domain, until the node is destroyed.

    Args:
        node: The node that publishes the address.
        address: The address without a path, e.g. `http://127.0.0.1:8080`. It must not contain a
            token, because all nodes of the domain can read the address.
    """
    message_type: Any = get_message(_TYPE)
    facts = {"host": socket.gethostname(), "address": address}
    node.create_publisher(message_type, TOPIC, _LATCHED).publish(
        message_type(data=json.dumps(facts))
    )


def running_page(node: Node) -> str | None:
    """Return the address of this machine's page for the node's domain.

    Return None if there is no page.

    Args:
        node: The node that subscribes. Executors must not spin this node.
    """
    if not node.count_publishers(TOPIC):
        return None
    message_type: Any = get_message(_TYPE)
    came, message = wait_for_message(
        message_type, node, TOPIC, qos_profile=_LATCHED, time_to_wait=_PATIENCE_S
    )
    if not came or message is None:
        return None
    return address_in(message.data)


def address_in(text: str) -> str | None:
    """Return the address in an announcement.

    Return None if the announcement is invalid or from another machine.
    """
    try:
        facts = read_json_object(text)
    except JsonError:
        return None  # any program can publish on the topic
    address = facts.get("address")
    if facts.get("host") != socket.gethostname() or not isinstance(address, str):
        return None
    return address if _ADDRESS.fullmatch(address) else None
