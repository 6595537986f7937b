"""Endpoint of a topic or a service, as `zbot topic info` and `zbot service info` print it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.qos import HistoryPolicy
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.qos import QoSProfile
    from zbot.time import Duration
    from zbot.wire.tokens import EndpointToken

#: ros2 prints this line for the ends of a service only.
_COUNT = {"Service": ("Endpoint count: 1",)}


def endpoint_json(end: EndpointToken) -> dict[str, object]:
    """Return an endpoint as a value for JSON."""
    return {
        "node": end.full_node_name,
        "type": end.type_name,
        "type_hash": end.type_hash,
        "gid": end.gid.hex(),
    }


def endpoint_text(end: EndpointToken, noun: str) -> str:
    """Return the lines of an endpoint.

    Args:
        end: The endpoint.
        noun: `Topic` or `Service`.
    """
    return "\n".join(
        (
            f"Node name: {end.node}",
            f"Node namespace: {end.namespace}",
            f"{noun} type: {end.type_name}",
            f"{noun} type hash: {end.type_hash}",
            f"Endpoint type: {'SERVER' if end.kind is EntityKind.SERVICE else end.kind.name}",
            *_COUNT.get(noun, ()),
            f"GID: {end.gid.hex('.')}",
            "QoS profile:",
            *_profile_lines(end.qos),
        )
    )


def _profile_lines(qos: QoSProfile) -> list[str]:
    depth = f" ({qos.depth})" if qos.history is HistoryPolicy.KEEP_LAST else ""
    return [
        f"  Reliability: {qos.reliability.name}",
        f"  History (Depth): {qos.history.name}{depth}",
        f"  Durability: {qos.durability.name}",
        f"  Lifespan: {_duration(qos.lifespan)}",
        f"  Deadline: {_duration(qos.deadline)}",
        f"  Liveliness: {qos.liveliness.name}",
        f"  Liveliness lease duration: {_duration(qos.liveliness_lease_duration)}",
    ]


def _duration(duration: Duration) -> str:
    infinite = duration.nanoseconds in {0, 2**63 - 1}
    return "Infinite" if infinite else f"{duration.nanoseconds} nanoseconds"
