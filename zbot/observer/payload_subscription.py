"""Subscriptions that deliver messages as bytes, to decode only the messages that are needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription
    from zbot.qos import QoSProfile

#: Messages that can wait while the executor is busy. Lost messages are counted.
QUEUE_DEPTH = 100


def subscribe_to_payloads(
    node: Node,
    message_type: Any,
    topic: str,
    take: Callable[[bytes, MessageInfo], object],
    profile: QoSProfile,
) -> Subscription[Any]:
    """Return a subscription whose callback receives undecoded payloads.

    The subscription counts lost messages.

    The decoder for the payloads is `context.dialect.codec_for(message_type).decode`.
    """
    subscription = node.create_subscription(message_type, topic, take, profile, raw="payload")
    subscription.report_losses_to(_ignore)
    return subscription


def _ignore(_missing: int) -> None:
    """Do nothing. With this listener, the subscription does not log a warning of lost messages."""
