"""Which class or partner this machine has joined: a small file that every program reads.

`zbot join`, `zbot leave` and `zbot class` write it. It says which domain is this machine's own and
with which name and secret its sessions speak to each other and to its hub.
"""

from __future__ import annotations

import json
import os
import sys
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from zbot.errors import SetupError

if TYPE_CHECKING:
    from collections.abc import Iterable

FILE = "membership.json"
USERS_FILE = "users.txt"

Role = Literal["teacher", "student", "partner"]


class MembershipError(SetupError, ValueError):
    """The file that says what this machine has joined cannot be understood."""

    def __init__(self, path: Path, reason: str) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"cannot read {path} ({reason}): `zbot leave` removes it, then join again")


@dataclass(frozen=True)
class Membership:
    """What this machine has joined."""

    role: Role  #: `partner` joined a plain hub, without a class
    host: str  #: where the hub that it joined is; the teacher's own address
    port: int
    class_name: str = ""
    number: int = 0  #: the student's number, which is this machine's domain; 0 otherwise
    name: str = ""  #: of the student
    user: str = ""  #: with which sessions introduce themselves; empty where nobody asks
    secret: str = field(default="", repr=False)
    claim: str = ""  #: tells this claim of the number from others
    hub_id: str = ""  #: the Zenoh id that a class knows this machine's hub by
    keystore: str = ""  #: folder of this machine's certificate, where hubs use them

    @property
    def in_class(self) -> bool:
        """Whether there is a class, with numbers and a shared space."""
        return self.role != "partner"


def folder() -> Path:
    """Return the folder for the user's own settings; it need not exist yet.

    `$XDG_CONFIG_HOME/zbot` where that is set, else what the system uses: `~/.config/zbot`,
    `~/Library/Application Support/zbot` on macOS, `%APPDATA%/zbot` on Windows.
    """
    base = os.environ.get("XDG_CONFIG_HOME")
    if base:
        return Path(base) / "zbot"
    if sys.platform == "win32":
        return Path(os.environ.get("APPDATA") or Path.home() / "AppData" / "Roaming") / "zbot"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "zbot"
    return Path.home() / ".config" / "zbot"


def load() -> Membership | None:
    """Return what this machine has joined; `None` if nothing.

    Raises:
        MembershipError: The file is damaged.
    """
    path = folder() / FILE
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as exc:
        raise MembershipError(path, getattr(exc, "strerror", None) or str(exc)) from exc
    return _parsed(path, text)


def _parsed(path: Path, text: str) -> Membership:
    known = {field.name for field in fields(Membership)}
    try:
        document: dict[str, Any] = json.loads(text)
        return Membership(**{key: value for key, value in document.items() if key in known})
    except (ValueError, TypeError, AttributeError) as exc:
        raise MembershipError(path, str(exc)) from exc


def save(membership: Membership, users: Iterable[tuple[str, str]] = ()) -> None:
    """Write what this machine has joined, for its user's eyes only.

    Args:
        membership: What.
        users: Whom its sessions let in, with their secrets; where they introduce themselves.
    """
    from zbot.security.secret import make_private_folder, write_private  # noqa: PLC0415 - seldom

    make_private_folder(folder())
    if membership.user:
        save_users(users)
    write_private(folder() / FILE, json.dumps(asdict(membership), indent=2).encode() + b"\n")


def save_users(users: Iterable[tuple[str, str]]) -> None:
    """Write whom this machine's sessions let in from now on; Zenoh reads it when one opens."""
    from zbot.security.secret import write_private  # noqa: PLC0415 - seldom

    lines = "".join(f"{user}:{secret}\n" for user, secret in users)
    write_private(folder() / USERS_FILE, lines.encode())


def forget() -> None:
    """Remove what was written; nothing happens if there is nothing."""
    for name in (FILE, USERS_FILE):
        (folder() / name).unlink(missing_ok=True)


def session_settings(membership: Membership | None) -> dict[str, Any]:
    """Return what Zenoh needs to know for a session of this machine to be let in by the others.

    A session that introduces itself refuses whoever does not, so all of a machine's must.
    """
    if membership is None or not membership.user:
        return {}
    return {
        "transport/auth/usrpwd/user": membership.user,
        "transport/auth/usrpwd/password": membership.secret,
        "transport/auth/usrpwd/dictionary_file": str(folder() / USERS_FILE),
    }
