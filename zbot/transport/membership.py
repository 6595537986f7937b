"""Membership file: the class of students, or the other machine's hub, that this machine joined.

`zbot join`, `zbot leave` and `zbot class` write the file, and every program reads it. It contains
this machine's domain, user name and secret. This machine's sessions use the name and the secret to
log in to each other and to the hub.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field, fields
from typing import TYPE_CHECKING, Any, Literal

from zbot.errors import SetupError
from zbot.package.user_folders import settings_folder
from zbot.text.json_reader import read_json_object

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

FILE = "membership.json"
USERS_FILE = "users.txt"
_LOGIN_DIGITS = 16

Role = Literal["teacher", "student", "partner"]


class MembershipError(SetupError, ValueError):
    """The membership file cannot be read, or is damaged."""

    def __init__(self, path: Path, reason: str) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"cannot read {path} ({reason}): `zbot leave` removes it, then join again")


@dataclass(frozen=True)
class Membership:
    """The class or hub that this machine has joined."""

    role: Role  #: `partner` means that the machine joined a hub without a class
    host: str  #: address of the joined hub; on the teacher's machine, its own address
    port: int
    class_name: str = ""
    number: int = 0  #: the student's number, which is this machine's domain (0 if there is none)
    name: str = ""  #: the student's name
    user: str = ""  #: the user name that sessions log in with, empty if they need no user name
    secret: str = field(default="", repr=False)
    claim: str = ""  #: identifies this machine's request for the number
    hub_id: str = ""  #: the Zenoh id of this machine's hub, as the class knows it
    hub_port: int = 0  #: port of this machine's own hub on 127.0.0.1
    version: str = ""  #: version of zbot that the class or hub had, empty if it is unknown
    keystore: str = ""  #: folder of this machine's certificate, if the hubs use certificates

    @property
    def in_class(self) -> bool:
        """Whether the machine is in a class. Otherwise it has joined a hub without a class."""
        return self.role != "partner"


def folder() -> Path:
    """Return the folder for the user's own settings. The folder may not exist yet."""
    return settings_folder()


def load() -> Membership | None:
    """Return this machine's membership, or `None` if it has not joined a class or hub.

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
        document = read_json_object(text)
        return Membership(**{key: value for key, value in document.items() if key in known})
    except (ValueError, TypeError, AttributeError) as exc:
        raise MembershipError(path, str(exc)) from exc


def save(membership: Membership, users: Iterable[tuple[str, str]] = ()) -> None:
    """Write this machine's membership to files that only their owner can read.

    Args:
        membership: The membership.
        users: Names and secrets of the users that may log in to this machine's sessions.
    """
    from zbot.security.secret import make_private_folder, write_private  # noqa: PLC0415 - rare

    make_private_folder(folder())
    if membership.user:
        save_users(users)
    write_private(folder() / FILE, json.dumps(asdict(membership), indent=2).encode() + b"\n")


def save_users(users: Iterable[tuple[str, str]]) -> None:
    """Write the users that may log in to this machine's sessions. Open sessions do not change."""
    from zbot.security.secret import write_private  # noqa: PLC0415 - rarely needed

    lines = "".join(f"{user}:{secret}\n" for user, secret in users)
    write_private(folder() / USERS_FILE, lines.encode())


def forget() -> None:
    """Remove the membership files. Do nothing if there are no files."""
    for name in (FILE, USERS_FILE):
        (folder() / name).unlink(missing_ok=True)


def login(membership: Membership | None) -> str:
    """Return a text that is equal for sessions with the same user name and secret."""
    if membership is None or not membership.user:
        return ""
    import hashlib  # noqa: PLC0415 - only classes with a PIN need it

    text = f"{membership.user}:{membership.secret}"
    return hashlib.sha256(text.encode()).hexdigest()[:_LOGIN_DIGITS]


def session_settings(membership: Membership | None) -> dict[str, Any]:
    """Return the Zenoh settings that a session of this machine needs to log in to other sessions.

    If one session has a user name, it refuses sessions without a user name. So all sessions of a
    machine need these settings.
    """
    if membership is None or not membership.user:
        return {}
    return {
        "transport/auth/usrpwd/user": membership.user,
        "transport/auth/usrpwd/password": membership.secret,
        "transport/auth/usrpwd/dictionary_file": str(folder() / USERS_FILE),
    }
