"""Declaration of Zenoh publishers and subscribers that behave as a QoS profile says."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.qos import DurabilityPolicy, HistoryPolicy, ReliabilityPolicy

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.qos import QoSProfile
    from zbot.wire.tokens import EndpointToken

# Time from a burst of samples to a heartbeat, as in rmw_zenoh. A heartbeat contains the number of
# the last sample, so subscribers find missing samples.
_HEARTBEAT_S = 0.5
# How many messages a keep-all publisher keeps for late subscribers. Zenoh requires a limit.
_KEEP_ALL_CACHE = 1000


def is_reliable(qos: QoSProfile) -> bool:
    """Return whether lost messages are sent again."""
    return qos.reliability is not ReliabilityPolicy.BEST_EFFORT


def can_block(qos: QoSProfile) -> bool:
    """Return whether a publisher waits for subscribers whose queues are full."""
    return is_reliable(qos) and qos.history is HistoryPolicy.KEEP_ALL


def declare_publisher(context: Context, token: EndpointToken) -> Any:
    """Return a Zenoh publisher with the reliability, history and durability in a token."""
    qos = token.qos
    reliable = is_reliable(qos)
    keep_all = qos.history is HistoryPolicy.KEEP_ALL
    block = can_block(qos)
    options: dict[str, Any] = {
        "encoding": context.dialect.encoding(token.type_name),
        "reliability": zenoh.Reliability.RELIABLE if reliable else zenoh.Reliability.BEST_EFFORT,
        "congestion_control": (
            zenoh.CongestionControl.BLOCK if block else zenoh.CongestionControl.DROP
        ),
    }
    key = context.dialect.data_key(token)
    if qos.durability is not DurabilityPolicy.TRANSIENT_LOCAL:
        return context.session.declare_publisher(key, **options)
    kept = context.graph.numbers.kept(token)
    if kept is not None:
        return kept
    import zenoh.ext as advanced  # noqa: PLC0415 - only transient local topics need it

    # With miss detection, Zenoh numbers the samples. So the samples need no timestamps, which would
    # cost time in every publisher of the session.
    options["sample_miss_detection"] = advanced.MissDetectionConfig(
        heartbeat=None, sporadic_heartbeat=_HEARTBEAT_S if reliable else None
    )
    depth = _KEEP_ALL_CACHE if keep_all else max(qos.depth, 1)
    return advanced.declare_advanced_publisher(
        context.session,
        key,
        cache=advanced.CacheConfig(depth),
        publisher_detection=True,
        **options,
    )


def subscriber_declaration(
    context: Context, token: EndpointToken, depth: int
) -> Callable[[Any], Any]:
    """Return a function that declares a Zenoh subscriber, with the durability in a token.

    Args:
        context: The context whose session subscribes.
        token: The subscription's token.
        depth: How many past samples a transient local subscription wants.

    Returns:
        A function that takes Zenoh's handler of the samples, and returns the subscriber.
    """
    key = context.dialect.subscription_key(token)
    if token.qos.durability is not DurabilityPolicy.TRANSIENT_LOCAL:
        return partial(context.session.declare_subscriber, key)
    import zenoh.ext as advanced  # noqa: PLC0415 - only transient local topics need it

    return partial(
        advanced.declare_advanced_subscriber,
        context.session,
        key,
        history=advanced.HistoryConfig(detect_late_publishers=True, max_samples=depth),
        recovery=advanced.RecoveryConfig(periodic_queries=None, heartbeat=True),
    )
