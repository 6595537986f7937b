"""One way of writing keys, tokens and messages; the rest of zbot talks through it.

zbot has its own dialect. That of ROS 2 over Zenoh differs in the form of keys and tokens and in the
codec only, and would be a second class with these methods.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, TypeVar

from zbot.wire import keys, tokens

if TYPE_CHECKING:
    from zbot.wire.codec import Codec
    from zbot.wire.tokens import EndpointToken, NodeToken

__all__ = ["IN_CLASS", "NATIVE", "Dialect", "other_type"]

MessageT = TypeVar("MessageT")


class Dialect(Protocol):
    """What a session needs to know about the wire."""

    def topic_key(self, domain: int, name: str) -> str:
        """Return the key of a fully qualified topic or service name."""
        ...

    def parse_key(self, key: str) -> tuple[int, str] | None:
        """Return domain and name of a key, or None if it is no topic's."""
        ...

    def domain_of(self, domain: int, name: str) -> int:
        """Return the domain that a topic or service of a node belongs to, usually the node's."""
        ...

    def tokens_keys(self, domain: int) -> tuple[str, ...]:
        """Return the key expressions of every liveliness token that a domain's nodes should see."""
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

    @staticmethod
    def topic_key(domain: int, name: str) -> str:
        return keys.topic_key(domain, name)

    parse_key = staticmethod(keys.parse_key)

    @staticmethod
    def domain_of(domain: int, name: str) -> int:  # noqa: ARG004 - the shared one looks at it
        return domain

    @staticmethod
    def tokens_keys(domain: int) -> tuple[str, ...]:
        return (tokens.token_selector(domain),)

    parse_token = staticmethod(tokens.parse_token)
    encoding = staticmethod(keys.encoding)

    @staticmethod
    def codec_for(message_class: type[MessageT]) -> Codec[MessageT]:
        from zbot.wire.codec import codec_for  # noqa: PLC0415 - lists read no messages

        return codec_for(message_class)


class _InClass(_Native):
    """The same where domains are those of students, which have the names in `/class/` in common."""

    @staticmethod
    def topic_key(domain: int, name: str) -> str:
        return name[1:] if keys.is_shared(name) else keys.topic_key(domain, name)

    @staticmethod
    def domain_of(domain: int, name: str) -> int:
        return keys.SHARED_DOMAIN if keys.is_shared(name) else domain

    @staticmethod
    def tokens_keys(domain: int) -> tuple[str, ...]:
        return (tokens.token_selector(domain), tokens.token_selector(keys.SHARED_DOMAIN))


NATIVE: Dialect = _Native()
IN_CLASS: Dialect = _InClass()


def other_type(dialect: Dialect, encoding: object, expected: str) -> str:
    """Return which other type an encoding names, in words; empty if it names this one or none."""
    told, prefix = str(encoding), dialect.encoding("")
    given = told.removeprefix(prefix) if told.startswith(prefix) else ""
    return "" if given in {"", expected} else f"it is {given}, not {expected}"
