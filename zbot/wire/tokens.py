"""Liveliness tokens, with which nodes and their endpoints announce themselves.

A token is a Zenoh key that exists until its entity or its session ends. `zbot node list` and
`zbot topic info` read all their information from tokens. The grammar is rmw_zenoh's:

    @zbot/<domain>/<zid>/<nid>/<nid>/NN/<enclave>/<namespace>/<node>
    @zbot/<domain>/<zid>/<nid>/<eid>/<kind>/<enclave>/<namespace>/<node>/<name>/<type>/<hash>/<qos>

ROS 2's own tokens begin with `@ros2_lv` (see `zbot.wire.rmw_zenoh`).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from typing import TYPE_CHECKING

from zbot.names import fully_qualified
from zbot.text.whole_number import whole_number
from zbot.wire.attachment import GID_LENGTH
from zbot.wire.errors import TokenError
from zbot.wire.keys import SHARED_DOMAIN, SHARED_SPACE, domain_text
from zbot.wire.qos import parse_qos, qos_text

if TYPE_CHECKING:
    from zbot.qos import QoSProfile

__all__ = [
    "ROS2_TOKEN_PREFIX",
    "TOKEN_PREFIX",
    "EndpointToken",
    "EntityKind",
    "NodeToken",
    "gid_of",
    "mangle",
    "mangled_key",
    "namesake_selector",
    "parse_token",
    "token_selector",
    "type_selector",
]

TOKEN_PREFIX = "@zbot"  # noqa: S105 - a key's first chunk, not a secret
ROS2_TOKEN_PREFIX = "@ros2_lv"  # noqa: S105 - as above
_NODE_CHUNKS = 9
_ENDPOINT_CHUNKS = 13
_MAX_DIGITS = 10


class EntityKind(str, Enum):
    """Kind of the entity that a token announces."""

    NODE = "NN"
    PUBLISHER = "MP"
    SUBSCRIPTION = "MS"
    SERVICE = "SS"
    CLIENT = "SC"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class _Token:
    """Fields of the tokens of nodes and of endpoints."""

    domain: int  #: `SHARED_DOMAIN` if all domains of a classroom share the name of an endpoint
    zid: str  #: id of the Zenoh session, in the form in which Zenoh prints it
    nid: int  #: number of the node in its session
    namespace: str  #: the node's absolute namespace, `/` for the root
    node: str  #: the node's base name
    enclave: str = "/"
    key: str = ""  #: the token's Zenoh key, which is made from the other fields if it is not given

    @property
    def full_node_name(self) -> str:
        """The full name of the node, which is the namespace and the base name."""
        return fully_qualified(self.namespace, self.node)

    @property
    def gid(self) -> bytes:
        """The id of the node or endpoint, 16 bytes. The attachment of each message has this id."""
        return gid_of(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Token) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class NodeToken(_Token):
    """Token of a node."""

    def __post_init__(self) -> None:
        if not self.key:
            object.__setattr__(self, "key", mangled_key(TOKEN_PREFIX, self))

    @property
    def kind(self) -> EntityKind:
        """The kind of entity."""
        return EntityKind.NODE


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class EndpointToken(_Token):
    """Token of a publisher, subscription, service or client."""

    eid: int  #: number of the endpoint in its session
    kind: EntityKind
    name: str  #: fully qualified name of the topic or service
    type_name: str  #: `std_msgs/msg/String`
    type_hash: str  #: `RIHS01_...`
    qos: QoSProfile

    def __post_init__(self) -> None:
        if not self.key:
            fields = map(mangle, (self.name, self.type_name, self.type_hash))
            node_key = mangled_key(TOKEN_PREFIX, self)
            object.__setattr__(self, "key", "/".join((node_key, *fields, qos_text(self.qos))))


def token_selector(domain: int, prefix: str = TOKEN_PREFIX) -> str:
    """Return the key expression of all tokens of a domain."""
    return f"{prefix}/{domain_text(domain)}/**"


def namesake_selector(token: NodeToken | EndpointToken, prefix: str = TOKEN_PREFIX) -> str:
    """Return the key expression of the tokens with a node's name or with an endpoint's topic."""
    domain = f"{prefix}/{domain_text(token.domain)}"
    if isinstance(token, NodeToken):
        full = "/".join(map(mangle, (token.namespace, token.node)))
        return f"{domain}/*/*/*/{EntityKind.NODE.value}/*/{full}"
    return f"{domain}/*/*/*/*/*/*/*/{mangle(token.name)}/**"


def type_selector(domain: int, kind: EntityKind, type_name: str, prefix: str = TOKEN_PREFIX) -> str:
    """Return the key expression of the endpoints of one kind and type, whatever their names are."""
    return f"{prefix}/{domain_text(domain)}/*/*/*/{kind.value}/*/*/*/*/{mangle(type_name)}/**"


# Each access to a token's `gid` calls this function, and there are only a few different keys.
@lru_cache(maxsize=4096)
def gid_of(key: str) -> bytes:
    """Return the 16 bytes that identify a token's owner: the hash of the token's text.

    The hash is XXH3 for a token of ROS 2, and BLAKE2b for a token of zbot.
    """
    if key.startswith(ROS2_TOKEN_PREFIX):
        import xxhash  # noqa: PLC0415 - only contexts with ROS 2's dialect need it

        low_half_first: bytes = xxhash.xxh3_128_digest(key.encode())[::-1]
        return low_half_first
    import hashlib  # noqa: PLC0415 - 4 ms, and commands that only list need no gids

    return hashlib.blake2b(key.encode(), digest_size=GID_LENGTH).digest()


def parse_token(key: str, prefix: str = TOKEN_PREFIX) -> NodeToken | EndpointToken:
    """Return the token in a liveliness key. Chunks that a later version adds are ignored.

    Raises:
        TokenError: The key is not a token with this prefix.
    """
    chunks = key.split("/")
    if chunks[0] != prefix:
        raise TokenError(key, f"it does not begin with {prefix}")
    if len(chunks) < _NODE_CHUNKS:
        raise TokenError(key, f"it has {len(chunks)} chunks and needs at least {_NODE_CHUNKS}")
    if "" in chunks or not key.isprintable():
        raise TokenError(key, "it has an empty chunk or a control character")
    if chunks[5] == EntityKind.NODE.value:
        return _node_token(key, chunks)
    return _endpoint_token(key, chunks)


def _node_token(key: str, chunks: list[str]) -> NodeToken:
    return NodeToken(
        domain=_domain(key, chunks[1]),
        zid=chunks[2],
        nid=_number(key, chunks[3]),
        enclave=_demangle(chunks[6]),
        namespace=_demangle(chunks[7]),
        node=_demangle(chunks[8]),
        key=key,
    )


def _endpoint_token(key: str, chunks: list[str]) -> EndpointToken:
    if len(chunks) < _ENDPOINT_CHUNKS:
        reason = f"it has {len(chunks)} chunks and an endpoint needs {_ENDPOINT_CHUNKS}"
        raise TokenError(key, reason)
    try:
        kind, qos = EntityKind(chunks[5]), parse_qos(chunks[12])
    except ValueError as error:
        raise TokenError(key, str(error)) from error
    return EndpointToken(
        domain=_domain(key, chunks[1]),
        zid=chunks[2],
        nid=_number(key, chunks[3]),
        eid=_number(key, chunks[4]),
        kind=kind,
        enclave=_demangle(chunks[6]),
        namespace=_demangle(chunks[7]),
        node=_demangle(chunks[8]),
        name=_demangle(chunks[9]),
        type_name=_demangle(chunks[10]),
        type_hash=_demangle(chunks[11]),
        qos=qos,
        key=key,
    )


def mangled_key(prefix: str, token: NodeToken | EndpointToken) -> str:
    """Return the first nine chunks of a token. The token of a node has only these chunks."""
    eid = token.nid if isinstance(token, NodeToken) else token.eid
    ids = f"{domain_text(token.domain)}/{token.zid}/{token.nid}/{eid}/{token.kind.value}"
    names = "/".join(map(mangle, (token.enclave, token.namespace, token.node)))
    return f"{prefix}/{ids}/{names}"


def mangle(field: str) -> str:
    """Return a field with `%` in place of `/`, which separates chunks. No ROS 2 name has a `%`."""
    return field.replace("/", "%")


def _demangle(chunk: str) -> str:
    return chunk.replace("%", "/")


def _domain(key: str, chunk: str) -> int:
    return SHARED_DOMAIN if chunk == SHARED_SPACE else _number(key, chunk)


def _number(key: str, chunk: str) -> int:
    number = whole_number(chunk, _MAX_DIGITS)
    if number is None:
        raise TokenError(key, f"{chunk!r} is not a number")
    return number
