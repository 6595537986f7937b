"""Student of a class, and what the class knows about the student's laptop."""

from __future__ import annotations

import secrets
from dataclasses import dataclass, field
from typing import Any, NamedTuple

_CLAIM_BYTES = 8


@dataclass(frozen=True)
class Student:
    """A student who has joined."""

    number: int
    name: str
    machine: str  #: random text that identifies the laptop
    host: str  #: the laptop's host name
    claim: str = field(default_factory=lambda: secrets.token_hex(_CLAIM_BYTES))


@dataclass
class Laptop:
    """When a student's laptop was seen, and what it has reported."""

    is_here: bool = False
    since_ns: int = 0  #: time of the last connection or disconnection (0 if never connected)
    version: str = ""
    system: str = ""
    last_error: dict[str, Any] | None = field(default=None)
    clock_offset_s: float | None = None  #: the laptop's clock minus the teacher's


class Identity(NamedTuple):
    """Identity of one owner of a number. The teacher's hub accepts the owner's laptop with it."""

    user: str
    secret: str
    hub_id: str  #: Zenoh id of the laptop's hub in lower-case hex digits. It begins with `f`


def user_of(number: int) -> str:
    """Return a student's user name."""
    return f"student{number}"
