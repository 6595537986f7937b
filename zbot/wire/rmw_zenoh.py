"""Dialect of ROS 2's Zenoh middleware, `rmw_zenoh_cpp`.

A context with this dialect is a ROS 2 participant: its keys, tokens, payloads and attachments are
those of ROS 2 itself. Humble has no type hashes, so there is a second dialect for Humble.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from zbot.qos import DurabilityPolicy
from zbot.wire import error_reply, tokens
from zbot.wire.attachment import LAYOUT
from zbot.wire.dialect import RMW_ZENOH
from zbot.wire.errors import TokenError
from zbot.wire.payload import is_cdr
from zbot.wire.qos import qos_text
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.wire.dialect import Dialect, MessageCodec

__all__ = [
    "HUMBLE",
    "NO_HASH",
    "ROS2",
    "dds_type",
    "dialect_of",
    "ros_type",
]

MessageT = TypeVar("MessageT")
TokenT = TypeVar("TokenT", bound=NodeToken | EndpointToken)

NO_HASH = "TypeHashNotSupported"  #: Humble's text in place of a type hash
# Zenoh's default encoding, which Zenoh does not send. ROS 2 ignores encodings.
_ENCODING = "zenoh/bytes"
_DDS = "dds_"
# A server of ROS 2 refuses a second request with the same number, so each request is sent once.
# The first timeout is that of ROS 2's sessions. The result of an action may take any time.
_TIMEOUT_S = 600.0
_RESULT_TIMEOUT_S = 365 * 86400.0
# ROS 2 Lyrical and later versions publish messages with `uint8[]` on keys below the topic's key.
# Their tokens have an additional chunk. A subscription whose token lacks this chunk may receive no
# messages.
_BACKENDS = "backends:cpu:"
_OTHER_BUFFER = "/_buf/"  # in the key if the data are in the memory of another device


def dds_type(name: str) -> str:
    """Return the name of a type in ROS 2's keys: `std_msgs::msg::dds_::String_`."""
    *spaces, last = name.split("/")
    return "::".join((*spaces, _DDS, f"{last}_"))


def ros_type(name: str) -> str:
    """Return `std_msgs/msg/String` for ROS 2's name in keys. Return other names as they are."""
    *spaces, marker, last = ("", *name.split("::"))
    if marker != _DDS or not last.endswith("_"):
        return name
    return "/".join((*spaces[1:], last[:-1]))


def dialect_of(found: Iterable[str], *, distro: str = "") -> Dialect:
    """Return the dialect that the endpoints of a domain speak.

    Args:
        found: The keys of the domain's tokens. Other keys are ignored.
        distro: Name of the ROS 2 distribution. It is used only when there is no endpoint, or when
            the endpoints speak both dialects.
    """
    endpoints = filter(None, map(_endpoint, found))
    speaks_humble = {endpoint.type_hash == NO_HASH for endpoint in endpoints}
    if len(speaks_humble) != 1:
        return HUMBLE if distro == "humble" else ROS2
    return HUMBLE if speaks_humble.pop() else ROS2


def _endpoint(key: str) -> EndpointToken | None:
    try:
        token = ROS2.parse_token(key)
    except TokenError:
        return None
    return token if isinstance(token, EndpointToken) else None


class _RmwZenohDialect:
    """Dialect of rmw_zenoh since spring 2025. Older versions have attachments of another form.

    Args:
        has_hashes: Whether keys and tokens have the hash of the type.
    """

    identifier = RMW_ZENOH
    calls_all_servers = True
    needs_equal_types = True

    def __init__(self, *, has_hashes: bool) -> None:
        self._has_hashes = has_hashes

    @staticmethod
    def topic_key(domain: int, name: str) -> str:
        return f"{domain}{name}/*/*"

    @staticmethod
    def data_key(token: EndpointToken) -> str:
        return f"{token.domain}{token.name}/{dds_type(token.type_name)}/{token.type_hash}"

    def subscription_key(self, token: EndpointToken) -> str:
        key = self.data_key(token)
        return f"{key}/**" if self.refuses_keys(token) else key

    def with_key(self, token: TokenT) -> TokenT:
        key = tokens.mangled_key(tokens.ROS2_TOKEN_PREFIX, token)
        if isinstance(token, NodeToken):
            return replace(token, key=key)
        type_hash = token.type_hash if self._has_hashes else NO_HASH
        named = replace(token, type_hash=type_hash)
        fields = (tokens.mangle(token.name), dds_type(token.type_name), type_hash)
        more = (_BACKENDS,) if self.refuses_keys(named) else ()
        return replace(named, key="/".join((key, *fields, qos_text(token.qos), *more)))

    @staticmethod
    def request_timeout_s(service: str) -> float | None:
        return _RESULT_TIMEOUT_S if service.endswith("/_action/get_result") else _TIMEOUT_S

    @staticmethod
    def domain_of(domain: int, name: str) -> int:  # noqa: ARG004 - names are not shared
        return domain

    @staticmethod
    def token_selectors(domain: int) -> tuple[str, ...]:
        return (tokens.token_selector(domain, tokens.ROS2_TOKEN_PREFIX),)

    @staticmethod
    def namesake_selector(token: NodeToken | EndpointToken) -> str:
        return tokens.namesake_selector(token, tokens.ROS2_TOKEN_PREFIX)

    @staticmethod
    def type_selector(domain: int, kind: EntityKind, type_name: str) -> str:
        named = dds_type(type_name)
        return tokens.type_selector(domain, kind, named, tokens.ROS2_TOKEN_PREFIX)

    @staticmethod
    def parse_token(key: str) -> NodeToken | EndpointToken:
        token = tokens.parse_token(key, tokens.ROS2_TOKEN_PREFIX)
        if isinstance(token, NodeToken):
            return token
        return replace(token, type_name=ros_type(token.type_name))

    @staticmethod
    def encoding(type_name: str) -> str:  # noqa: ARG004 - the type is in the key
        return _ENCODING

    @staticmethod
    def refusal(key: object, encoding: object, expected: str) -> str:  # noqa: ARG004 - as above
        is_elsewhere = _OTHER_BUFFER in str(key)
        return "its data are in the memory of another device, e.g. a GPU" if is_elsewhere else ""

    @staticmethod
    def refuses_keys(token: EndpointToken) -> bool:
        if token.kind is not EntityKind.SUBSCRIPTION or token.type_hash == NO_HASH:
            return False
        if token.qos.durability is DurabilityPolicy.TRANSIENT_LOCAL:
            return False
        from zbot.interfaces import has_byte_sequences  # noqa: PLC0415 - only subscriptions need it

        try:
            return has_byte_sequences(token.type_name)
        except LookupError:
            return False  # a dataclass without a definition

    @staticmethod
    def attachment_refusal(length: int | None) -> str:
        found = "no attachment" if length is None else f"an attachment of {length} bytes"
        return (
            f"it has {found}, but rmw_zenoh needs {LAYOUT.size} bytes "
            "(number, time, gid); a ROS 2 from before spring 2025 sends another one: update it"
        )

    @staticmethod
    def codec_for(message_class: type[MessageT]) -> MessageCodec[MessageT]:
        from zbot.wire.cdr.codec import cdr_codec_for  # noqa: PLC0415 - commands that only list need none

        return cdr_codec_for(message_class)  # pyright: ignore[reportReturnType] - see MessageCodec

    @staticmethod
    def payload_of(data: bytes, message_class: type[object]) -> bytes:
        from zbot.wire.transcoder.transcoder import to_cdr  # noqa: PLC0415 - few programs need it

        return data if is_cdr(data) else to_cdr(message_class)(data)

    @staticmethod
    def raw_decoder(message_class: type[object]) -> Callable[[bytes], bytes]:  # noqa: ARG004 - CDR
        return bytes

    @staticmethod
    def error_payload(error: BaseException) -> tuple[bytes, str]:
        # ROS 2 sends no error replies itself. If it receives one, it logs the payload as text.
        return error_reply.error_text(error).encode(), _ENCODING


ROS2: Dialect = _RmwZenohDialect(has_hashes=True)
HUMBLE: Dialect = _RmwZenohDialect(has_hashes=False)
