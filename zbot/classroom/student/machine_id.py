"""Identifier of this user's machine, by which a class knows a laptop again."""

from __future__ import annotations

import secrets

from zbot.security.secret import make_private_folder, write_private
from zbot.transport import membership

_MACHINE_BYTES = 8


def new_machine_id() -> str:
    """Return a random identifier."""
    return secrets.token_hex(_MACHINE_BYTES)


def machine_id() -> str:
    """Return the identifier of this user's machine. It is random and stored in a file."""
    try:
        return (membership.folder() / "machine").read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        made = new_machine_id()
        save_machine_id(made)
        return made


def save_machine_id(machine: str) -> None:
    """Let this machine have an identifier from now on."""
    make_private_folder(membership.folder())
    write_private(membership.folder() / "machine", machine.encode())
