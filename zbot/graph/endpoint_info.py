"""Description of a publisher or subscription, which `get_publishers_info_by_topic` returns."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import TYPE_CHECKING, ClassVar

from zbot.qos import HistoryPolicy, qos_profile_unknown
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.qos import QoSProfile
    from zbot.wire.tokens import EndpointToken

_DIGEST_LENGTH = 32  # SHA-256, in the first version of ROS 2's type hashes


class TopicEndpointTypeEnum(IntEnum):
    """Kind of an endpoint: publisher or subscription."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


_SIDES = {
    EntityKind.PUBLISHER: TopicEndpointTypeEnum.PUBLISHER,
    EntityKind.SUBSCRIPTION: TopicEndpointTypeEnum.SUBSCRIPTION,
}


@dataclass(slots=True)
class TypeHash:
    """Hash of a type. `str()` returns `RIHS01_...`.

    Args:
        version: The version of the hash's algorithm. Only version 1 exists.
        value: The digest, 32 bytes.
    """

    version: int = -1
    value: bytes = bytes(_DIGEST_LENGTH)

    #: A message field of the type `string` accepts a hash, and stores its text.
    _zbot_stands_for: ClassVar[str] = "string"
    _TYPE_HASH_SIZE: ClassVar[int] = _DIGEST_LENGTH

    @classmethod
    def parse(cls, text: str) -> TypeHash:
        """Read a hash from a text such as `RIHS01_df66...`. Other texts give an invalid hash."""
        head, _, digits = text.partition("_")
        try:
            return cls(int(head.removeprefix("RIHS")), bytes.fromhex(digits))
        except ValueError:
            return cls()

    def __str__(self) -> str:
        if self.version <= 0 or len(self.value) != _DIGEST_LENGTH:
            return "INVALID"
        return f"RIHS{self.version:02}_{self.value.hex()}"


@dataclass(slots=True)
class TopicEndpointInfo:
    """Node, type, gid and QoS profile of one publisher or subscription."""

    node_name: str = ""
    node_namespace: str = ""
    topic_type: str = ""
    topic_type_hash: TypeHash = field(default_factory=TypeHash)
    endpoint_type: TopicEndpointTypeEnum = TopicEndpointTypeEnum.INVALID
    endpoint_gid: list[int] = field(default_factory=list)
    qos_profile: QoSProfile = field(default_factory=lambda: qos_profile_unknown)

    @classmethod
    def of(cls, token: EndpointToken) -> TopicEndpointInfo:
        """Return the description of the endpoint that a token announces."""
        return cls(
            node_name=token.node,
            node_namespace=token.namespace,
            topic_type=token.type_name,
            topic_type_hash=TypeHash.parse(token.type_hash),
            endpoint_type=_SIDES.get(token.kind, TopicEndpointTypeEnum.INVALID),
            endpoint_gid=list(token.gid),
            qos_profile=token.qos,
        )

    def __str__(self) -> str:
        """Return the text that `ros2 topic info --verbose` prints."""
        qos = self.qos_profile
        depth = f" ({qos.depth})" if qos.history is HistoryPolicy.KEEP_LAST else ""
        return "\n".join(
            (
                f"Node name: {self.node_name}",
                f"Node namespace: {self.node_namespace}",
                f"Topic type: {self.topic_type}",
                f"Topic type hash: {self.topic_type_hash}",
                f"Endpoint type: {self.endpoint_type.name}",
                f"GID: {'.'.join(format(byte, '02x') for byte in self.endpoint_gid)}",
                "QoS profile:",
                f"  Reliability: {qos.reliability.name}",
                f"  History (Depth): {qos.history.name}{depth}",
                f"  Durability: {qos.durability.name}",
                f"  Lifespan: {qos.lifespan}",
                f"  Deadline: {qos.deadline}",
                f"  Liveliness: {qos.liveliness.name}",
                f"  Liveliness lease duration: {qos.liveliness_lease_duration}",
            )
        )
