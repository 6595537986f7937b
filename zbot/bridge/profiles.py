"""QoS profiles of a bridge's endpoints, made from the profiles of the endpoints that it links."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.bridge.side import DEPTH
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    QoSCompatibility,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
)

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.bridge.side import End


def profiles(
    publishers: Sequence[QoSProfile], subscriptions: Sequence[QoSProfile], queue: int
) -> tuple[QoSProfile, QoSProfile]:
    """Return the profile of the subscription on one side, and of the publisher on the other side.

    Both profiles promise what all `publishers` promise. Without publishers, both profiles satisfy
    all `subscriptions`. The depth of the subscription is at least `queue`, because the subscription
    must not lose messages while the bridge is busy.
    """
    promised = publishers or subscriptions
    is_reliable = all(one.reliability is not ReliabilityPolicy.BEST_EFFORT for one in publishers)
    is_latched = bool(promised) and _agree(promised, latched=bool(publishers))
    depths = (one.depth for one in promised if one.history is not HistoryPolicy.KEEP_ALL)
    depth = max([DEPTH, *depths])
    reliability = ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT
    durability = DurabilityPolicy.TRANSIENT_LOCAL if is_latched else DurabilityPolicy.VOLATILE
    # Each transient local publisher keeps at least one message for late subscriptions.
    kept = max(depth, len(publishers)) if is_latched else depth
    return (
        QoSProfile(depth=max(queue, kept), reliability=reliability, durability=durability),
        QoSProfile(depth=kept, reliability=reliability, durability=durability),
    )


def _agree(found: Sequence[QoSProfile], *, latched: bool) -> bool:
    are = [one.durability is DurabilityPolicy.TRANSIENT_LOCAL for one in found]
    return all(are) if latched else any(are)


def mismatches(publishers: Iterable[End], subscriptions: Iterable[End]) -> list[str]:
    """Return a sentence for each publisher and subscription that DDS would not connect."""
    subscriptions = list(subscriptions)
    found = []
    for publisher in publishers:
        for subscription in subscriptions:
            verdict, reason = qos_check_compatible(publisher.qos, subscription.qos)
            if verdict is QoSCompatibility.ERROR:
                text = reason.replace("ERROR: ", "").rstrip(";").replace(";", " and ")
                found.append(
                    f"{publisher.name}: {subscription.node} gets no messages of {publisher.node}: "
                    f"{text}"
                )
    return found
