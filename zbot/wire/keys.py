"""Zenoh keys of topics and services, and Zenoh encodings that contain a message's type."""

from __future__ import annotations

from zbot.text.whole_number import whole_number

__all__ = [
    "ENCODING_PREFIX",
    "SHARED_DOMAIN",
    "SHARED_SPACE",
    "domain_selector",
    "domain_text",
    "encoded_type",
    "encoding",
    "is_shared",
    "parse_key",
    "topic_key",
]

ENCODING_PREFIX = "application/msgpack;"
#: Domain of the names below `/class/`, which all domains of a classroom share.
SHARED_DOMAIN = 255
SHARED_SPACE = "class"  #: the text in keys in place of this domain's number
_MAX_DOMAIN_DIGITS = 3


def topic_key(domain: int, name: str) -> str:
    """Return the key of a fully qualified name, e.g. `0/a/b` for the name `/a/b` in domain 0."""
    return f"{domain}{name}"


def parse_key(key: str) -> tuple[int, str] | None:
    """Return the domain and the full name in a key, or None if the key has another form."""
    domain, slash, name = key.partition("/")
    number = whole_number(domain, _MAX_DOMAIN_DIGITS)
    return None if number is None or not name else (number, slash + name)


def is_shared(name: str) -> bool:
    """Return whether all domains of a classroom share a full name, e.g. `/class/chat`."""
    return name.startswith(f"/{SHARED_SPACE}/")


def domain_text(domain: int) -> str:
    """Return the text of a domain in keys and tokens."""
    return SHARED_SPACE if domain == SHARED_DOMAIN else str(domain)


def domain_selector(domain: int) -> str:
    """Return the key expression of all topics and services of a domain."""
    return f"{domain}/**"


def encoding(type_name: str) -> str:
    """Return the Zenoh encoding of a type's messages."""
    return ENCODING_PREFIX + type_name


def encoded_type(text: str) -> str | None:
    """Return the type in an encoding. Return None if it is not zbot's encoding or has no type."""
    return text.removeprefix(ENCODING_PREFIX) or None if text.startswith(ENCODING_PREFIX) else None
