"""QoS profiles of a bridge's endpoints, made from the profiles of the endpoints that it links."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.bridge.side import DEPTH
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    QoSCompatibility,
    QoSProfile,
    qos_check_compatible,
)
from zbot.remote.profiles import profile_to_subscribe

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
    wants_old = any(
        subscription.durability is DurabilityPolicy.TRANSIENT_LOCAL
        for subscription in subscriptions
    )
    wanted = DurabilityPolicy.TRANSIENT_LOCAL if wants_old else DurabilityPolicy.VOLATILE
    both = profile_to_subscribe(publishers, QoSProfile(depth=DEPTH, durability=wanted))
    depths = (
        profile.depth for profile in promised if profile.history is not HistoryPolicy.KEEP_ALL
    )
    kept = max([DEPTH, *depths])
    if both.durability is DurabilityPolicy.TRANSIENT_LOCAL:
        # Each transient local publisher keeps at least one message for late subscriptions.
        kept = max(kept, len(publishers))
    return _with_depth(both, max(queue, kept)), _with_depth(both, kept)


def _with_depth(profile: QoSProfile, depth: int) -> QoSProfile:
    return QoSProfile(depth=depth, reliability=profile.reliability, durability=profile.durability)


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
