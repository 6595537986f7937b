"""Dialects of the wire format. A dialect defines the form of a session's keys, tokens and payloads.

`NATIVE` is zbot's own dialect. `CLASSROOM` adds names that all domains of a classroom share. A
dialect for rmw_zenoh would be another Python class with the same methods.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, TypeVar

from zbot.wire import keys, tokens

if TYPE_CHECKING:
    from zbot.wire.codec import Codec
    from zbot.wire.tokens import EndpointToken, NodeToken

__all__ = ["CLASSROOM", "NATIVE", "Dialect", "type_mismatch"]

MessageT = TypeVar("MessageT")


class Dialect(Protocol):
    """Methods that a session needs from a wire format."""

    def topic_key(self, domain: int, name: str) -> str:
        """Return the key of a fully qualified topic or service name."""
        ...

    def parse_key(self, key: str) -> tuple[int, str] | None:
        """Return the domain and the name in a key. Return None if no topic has such a key."""
        ...

    def domain_of(self, domain: int, name: str) -> int:
        """Return the domain of a topic or service. Usually this is the node's domain, `domain`."""
        ...

    def token_selectors(self, domain: int) -> tuple[str, ...]:
        """Return the key expressions of all liveliness tokens that a domain's nodes should see."""
        ...

    def parse_token(self, key: str) -> NodeToken | EndpointToken:
        """Return the contents of a token. Raise `TokenError` if the token is not valid."""
        ...

    def encoding(self, type_name: str) -> str:
        """Return the Zenoh encoding of a type's messages."""
        ...

    def codec_for(self, message_class: type[MessageT]) -> Codec[MessageT]:
        """Return the codec of a message class."""
        ...


class _NativeDialect:
    """zbot's own dialect, with plain keys and MessagePack that any Zenoh program can read."""

    @staticmethod
    def topic_key(domain: int, name: str) -> str:
        return keys.topic_key(domain, name)

    parse_key = staticmethod(keys.parse_key)

    @staticmethod
    def domain_of(domain: int, name: str) -> int:  # noqa: ARG004 - the classroom dialect uses it
        return domain

    @staticmethod
    def token_selectors(domain: int) -> tuple[str, ...]:
        return (tokens.token_selector(domain),)

    parse_token = staticmethod(tokens.parse_token)
    encoding = staticmethod(keys.encoding)

    @staticmethod
    def codec_for(message_class: type[MessageT]) -> Codec[MessageT]:
        from zbot.wire.codec import codec_for  # noqa: PLC0415 - commands that only list need no codec

        return codec_for(message_class)


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


def type_mismatch(dialect: Dialect, encoding: object, expected: str) -> str:
    """Return `it is A, not B` if an encoding has another type than `expected`. Else return ""."""
    text, prefix = str(encoding), dialect.encoding("")
    given = text.removeprefix(prefix) if text.startswith(prefix) else ""
    return "" if given in {"", expected} else f"it is {given}, not {expected}"
