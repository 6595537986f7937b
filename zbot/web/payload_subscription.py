"""Subscriptions that keep messages as bytes until someone wants to see them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription
    from zbot.qos import QoSProfile


def subscribe_to_payloads(
    node: Node,
    message_type: Any,
    topic: str,
    take: Callable[[bytes, MessageInfo], object],
    profile: QoSProfile,
) -> Subscription[Any]:
    """Return a subscription whose callback takes payloads as they came. Lost ones are counted.

    The decoder for the payloads is `context.dialect.codec_for(message_type).decode`.
    """
    subscription = node.create_subscription(message_type, topic, take, profile, raw="payload")
    # A raw subscription does not check the type of a sample. With `raw = False` it does.
    # Without this check, messages of other types on the topic would be decoded as zeros.
    subscription.raw = False
    subscription.report_losses_to(_ignore)
    return subscription


def _ignore(_missing: int) -> None:
    """Ignore lost messages. The subscription counts them, and a page shows their number."""
