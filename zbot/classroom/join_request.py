"""Requests of a laptop to a class: to join, with names safe to print, and the proof of an owner."""

from __future__ import annotations

import hmac
from dataclasses import dataclass
from typing import Any

from zbot.text.terminal import single_line

_MACHINE_LENGTH = 64

Document = dict[str, Any]
MAX_NAME_LENGTH = 64


def clean_name(text: str) -> str:
    """Return a name that is safe to print: one line of at most 64 printable characters.

    Control characters and characters that change the direction of writing become spaces.
    """
    return single_line(text, MAX_NAME_LENGTH)


@dataclass(frozen=True)
class JoinRequest:
    """A laptop's request to join a class."""

    machine: str  #: identifies the laptop
    host: str  #: the laptop's host name
    name: str | None = None  #: the student's name
    number: int | None = None  #: the student's number, or `None` if the class shall choose it
    is_new: bool = False  #: whether a similar name in the list is another student

    @classmethod
    def of(cls, document: Document) -> JoinRequest:
        """Return the request in a document from a laptop. Invalid fields get their defaults."""
        number = document.get("number")
        return cls(
            str(document.get("machine"))[:_MACHINE_LENGTH],
            clean_name(str(document.get("host") or "")) or "a laptop",
            clean_name(str(document.get("name") or "")) or None,
            number if isinstance(number, int) else None,
            document.get("is_new") is True,
        )


def proof(claim: str, purpose: str) -> str:
    """Return the proof that the sender of a query owns its number.

    The claim is a random text. Only the owner knows it, because the class sent it encrypted.

    Args:
        claim: The claim of the number.
        purpose: What the query asks for: `release`, `member` or `nodes`.
    """
    return hmac.new(claim.encode(), purpose.encode(), "sha256").hexdigest()


def is_proof(given: object, claim: str, purpose: str) -> bool:
    """Return whether a value from a laptop is the proof of a claim."""
    text = str(given).encode(errors="backslashreplace")
    return hmac.compare_digest(proof(claim, purpose).encode(), text)
