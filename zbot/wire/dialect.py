"""Dialects of the wire format. A dialect defines the form of a session's keys, tokens and payloads.

`NATIVE` is zbot's own dialect. `CLASSROOM` adds names that all domains of a classroom share.
`zbot.wire.rmw_zenoh` is the dialect of ROS 2's Zenoh middleware. A context chooses its dialect
once, when it opens its session.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, TypeVar

from zbot.wire import error_reply, keys, tokens
from zbot.wire.payload import is_cdr

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

__all__ = ["CLASSROOM", "NATIVE", "RMW_ZENOH", "Dialect"]

MessageT = TypeVar("MessageT")
TokenT = TypeVar("TokenT", bound=tokens.NodeToken | tokens.EndpointToken)
#: Name of zbot's own wire format, as in ROS 2's `get_rmw_implementation_identifier`.
ZBOT_IDENTIFIER = "rmw_zbot_zenoh"
#: Name of ROS 2's Zenoh middleware.
RMW_ZENOH = "rmw_zenoh_cpp"


class MessageCodec(Protocol[MessageT]):
    """Codec of one message type.

    The codecs have a `cached_property` in place of a property. pyright does not accept this.
    """

    @property
    def encode(self) -> Callable[[MessageT], bytes]:
        """Return the bytes of a message. Raise `CodecError` if a field has a wrong value."""
        ...

    @property
    def decode(self) -> Callable[[bytes], MessageT]:
        """Return the message that bytes contain. Raise `CodecError` if they are not valid.

        Bytes of a text that are not UTF-8 become U+FFFD.
        """
        ...

    @property
    def decode_strictly(self) -> Callable[[bytes], MessageT]:
        """Do the same as `decode`, but refuse texts that are not UTF-8, and other such values."""
        ...


class Dialect(Protocol):
    """Methods that a session needs from a wire format."""

    @property
    def identifier(self) -> str:
        """The name of the middleware that speaks this dialect, as ROS 2 prints it."""
        ...

    @property
    def calls_all_servers(self) -> bool:
        """Whether a request goes to all servers of the service. The first response is used."""
        ...

    @property
    def needs_equal_types(self) -> bool:
        """Whether two endpoints need equal definitions of a type to exchange messages."""
        ...

    def topic_key(self, domain: int, name: str) -> str:
        """Return the key expression of a fully qualified topic or service name with any type."""
        ...

    def data_key(self, token: EndpointToken) -> str:
        """Return the key of the messages that an endpoint sends, or of a service's requests."""
        ...

    def subscription_key(self, token: EndpointToken) -> str:
        """Return the key expression that a subscription subscribes to."""
        ...

    def with_key(self, token: TokenT) -> TokenT:
        """Return the token of a local node or endpoint in the form that this dialect announces."""
        ...

    def request_timeout_s(self, service: str) -> float | None:
        """Return the seconds after which a request fails.

        `None` means that the request is repeated until a response arrives.

        Args:
            service: The full name of the service.
        """
        ...

    def domain_of(self, domain: int, name: str) -> int:
        """Return the domain of a topic or service. Usually this is the node's domain, `domain`."""
        ...

    def token_selectors(self, domain: int) -> tuple[str, ...]:
        """Return the key expressions of all liveliness tokens that a domain's nodes should see."""
        ...

    def namesake_selector(self, token: NodeToken | EndpointToken) -> str:
        """Return the key expression of all tokens with the same node name or topic name."""
        ...

    def type_selector(self, domain: int, kind: EntityKind, type_name: str) -> str:
        """Return the key expression of the endpoints of one kind and type."""
        ...

    def parse_token(self, key: str) -> NodeToken | EndpointToken:
        """Return the contents of a token. Raise `TokenError` if the token is not valid."""
        ...

    def encoding(self, type_name: str) -> str:
        """Return the Zenoh encoding of a type's messages."""
        ...

    def refusal(self, key: object, encoding: object, expected: str) -> str:
        """Return why messages with a key and an encoding cannot be decoded as type `expected`.

        The text is empty if nothing is wrong. A subscription calls this method once for each
        publisher. If `refuses_keys` is true, the subscription calls it for each message.
        """
        ...

    def refuses_keys(self, token: EndpointToken) -> bool:
        """Return whether a subscription must check the key of each message."""
        ...

    def attachment_refusal(self, length: int | None) -> str:
        """Return why a message without a valid attachment is refused, or "" if it is accepted.

        Args:
            length: The length of the attachment, or `None` if there is none.
        """
        ...

    def codec_for(self, message_class: type[MessageT]) -> MessageCodec[MessageT]:
        """Return the codec of a message class."""
        ...

    def payload_of(self, data: bytes, message_class: type[object]) -> bytes:
        """Return the payload for a serialized message. `data` is CDR or MessagePack."""
        ...

    def raw_decoder(self, message_class: type[object]) -> Callable[[bytes], bytes]:
        """Return a function that converts payloads to CDR."""
        ...

    def error_payload(self, error: BaseException) -> tuple[bytes, str]:
        """Return the payload and the encoding of a service's error reply."""
        ...


class _NativeDialect:
    """zbot's own dialect, with plain keys and MessagePack that any Zenoh program can read."""

    identifier = ZBOT_IDENTIFIER
    calls_all_servers = False
    needs_equal_types = False

    @staticmethod
    def topic_key(domain: int, name: str) -> str:
        return keys.topic_key(domain, name)

    def data_key(self, token: EndpointToken) -> str:
        return self.topic_key(token.domain, token.name)

    def subscription_key(self, token: EndpointToken) -> str:
        return self.data_key(token)

    @staticmethod
    def with_key(token: TokenT) -> TokenT:
        return token

    @staticmethod
    def request_timeout_s(service: str) -> float | None:  # noqa: ARG004 - the same for all
        return None

    @staticmethod
    def domain_of(domain: int, name: str) -> int:  # noqa: ARG004 - the classroom dialect uses it
        return domain

    @staticmethod
    def token_selectors(domain: int) -> tuple[str, ...]:
        return (tokens.token_selector(domain),)

    @staticmethod
    def namesake_selector(token: NodeToken | EndpointToken) -> str:
        return tokens.namesake_selector(token)

    @staticmethod
    def type_selector(domain: int, kind: EntityKind, type_name: str) -> str:
        return tokens.type_selector(domain, kind, type_name)

    @staticmethod
    def parse_token(key: str) -> NodeToken | EndpointToken:
        return tokens.parse_token(key)

    encoding = staticmethod(keys.encoding)

    @staticmethod
    def refusal(key: object, encoding: object, expected: str) -> str:  # noqa: ARG004 - no type in it
        given = keys.encoded_type(str(encoding))
        return "" if given in {None, expected} else f"it is {given}, not {expected}"

    @staticmethod
    def refuses_keys(token: EndpointToken) -> bool:  # noqa: ARG004 - all keys are accepted
        return False

    @staticmethod
    def attachment_refusal(length: int | None) -> str:  # noqa: ARG004 - any program may publish
        return ""

    @staticmethod
    def codec_for(message_class: type[MessageT]) -> MessageCodec[MessageT]:
        from zbot.wire.messagepack.codec import messagepack_codec_for  # noqa: PLC0415 - lists need none

        return messagepack_codec_for(message_class)  # pyright: ignore[reportReturnType] - see MessageCodec

    @staticmethod
    def payload_of(data: bytes, message_class: type[object]) -> bytes:
        from zbot.wire.transcoder.transcoder import to_messagepack  # noqa: PLC0415 - few programs need it

        return to_messagepack(message_class)(data) if is_cdr(data) else data

    @staticmethod
    def raw_decoder(message_class: type[object]) -> Callable[[bytes], bytes]:
        from zbot.wire.transcoder.transcoder import to_cdr  # noqa: PLC0415 - few programs need it

        return to_cdr(message_class)

    @staticmethod
    def error_payload(error: BaseException) -> tuple[bytes, str]:
        return error_reply.pack_error(error), error_reply.ENCODING


class _ClassroomDialect(_NativeDialect):
    """Dialect of a classroom. Each student has a domain, and all share the names in `/class/`."""

    @staticmethod
    def topic_key(domain: int, name: str) -> str:
        return name[1:] if keys.is_shared(name) else keys.topic_key(domain, name)

    @staticmethod
    def domain_of(domain: int, name: str) -> int:
        return keys.SHARED_DOMAIN if keys.is_shared(name) else domain

    @staticmethod
    def token_selectors(domain: int) -> tuple[str, ...]:
        return (tokens.token_selector(domain), tokens.token_selector(keys.SHARED_DOMAIN))


NATIVE: Dialect = _NativeDialect()
CLASSROOM: Dialect = _ClassroomDialect()
