"""One way of writing keys, tokens and messages; the rest of zbot talks through it.

zbot has its own dialect. That of ROS 2 over Zenoh differs in the form of keys and tokens and in the
codec only, and would be a second class with these methods.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, TypeVar

from zbot.wire import codec, keys, tokens

if TYPE_CHECKING:
    from zbot.wire.codec import Codec
    from zbot.wire.tokens import EndpointToken, NodeToken

__all__ = ["NATIVE", "Dialect"]

MessageT = TypeVar("MessageT")


class Dialect(Protocol):
    """What a session needs to know about the wire."""

    def topic_key(self, domain: int, name: str) -> str:
        """Return the key of a fully qualified topic or service name."""
        ...

    def parse_key(self, key: str) -> tuple[int, str] | None:
        """Return domain and name of a key, or None if it is no topic's."""
        ...

    def tokens_key(self, domain: int) -> str:
        """Return the key expression of every liveliness token of a domain."""
        ...

    def parse_token(self, key: str) -> NodeToken | EndpointToken:
        """Return what a token says, or raise TokenError."""
        ...

    def encoding(self, type_name: str) -> str:
        """Return the Zenoh encoding of a type's messages."""
        ...

    def codec_for(self, message_class: type[MessageT]) -> Codec[MessageT]:
        """Return what turns messages of a class into bytes and back."""
        ...


class _Native:
    """zbot's own dialect: plain keys and MessagePack, readable by any Zenoh program."""

    topic_key = staticmethod(keys.topic_key)
    parse_key = staticmethod(keys.parse_key)
    tokens_key = staticmethod(tokens.token_selector)
    parse_token = staticmethod(tokens.parse_token)
    encoding = staticmethod(keys.encoding)
    codec_for = staticmethod(codec.codec_for)


NATIVE: Dialect = _Native()
