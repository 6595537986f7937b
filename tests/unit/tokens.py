"""Tokens of endpoints, with the facts that a test gives."""

from __future__ import annotations

from itertools import count
from typing import Any

from zbot.qos import QoSProfile
from zbot.wire.tokens import EndpointToken, EntityKind

STRING = "std_msgs/msg/String"
_numbers = count(1)


def endpoint_token(name: str, **facts: Any) -> EndpointToken:
    """Return the token of a publisher of strings in domain 0, with other facts as given."""
    usual: dict[str, Any] = {
        "domain": 0,
        "zid": "a",
        "nid": 1,
        "eid": next(_numbers),
        "kind": EntityKind.PUBLISHER,
        "namespace": "/",
        "node": "talker",
        "type_name": STRING,
        "type_hash": "RIHS01_0",
        "qos": QoSProfile(depth=1),
    }
    return EndpointToken(name=name, **{**usual, **facts})
