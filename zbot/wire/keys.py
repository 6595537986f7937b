"""Zenoh keys of topics and services, and the encoding that names a message's type."""

from __future__ import annotations

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
#: The space that the domains of a class have in common, and what stands for its domain in keys.
SHARED_DOMAIN = 255
SHARED_SPACE = "class"
_MAX_DOMAIN_DIGITS = 3


def topic_key(domain: int, name: str) -> str:
    """Return the key of a fully qualified topic or service name: `/a/b` in domain 0 is `0/a/b`."""
    return f"{domain}{name}"


def parse_key(key: str) -> tuple[int, str] | None:
    """Return domain and fully qualified name of a key, or None if it is no topic's key."""
    domain, slash, name = key.partition("/")
    if not name or not is_number(domain) or len(domain) > _MAX_DOMAIN_DIGITS:
        return None
    return int(domain), slash + name


def is_shared(name: str) -> bool:
    """Return whether a class has a fully qualified name in common: `/class/...`."""
    return name.startswith(f"/{SHARED_SPACE}/")


def domain_text(domain: int) -> str:
    """Return what stands for a domain in keys and tokens."""
    return SHARED_SPACE if domain == SHARED_DOMAIN else str(domain)


def domain_selector(domain: int) -> str:
    """Return the key expression of every topic and service of a domain."""
    return f"{domain}/**"


def encoding(type_name: str) -> str:
    """Return the Zenoh encoding of a type's messages."""
    return ENCODING_PREFIX + type_name


def encoded_type(text: str) -> str | None:
    """Return the type that an encoding names, or None if it is none of ours or names no type."""
    return text.removeprefix(ENCODING_PREFIX) or None if text.startswith(ENCODING_PREFIX) else None


def is_number(text: str) -> bool:
    """Tell whether a key's chunk is a plain decimal number, which `int()` alone does not check."""
    return text.isascii() and text.isdigit()
