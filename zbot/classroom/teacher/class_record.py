"""Record of an open class, in a file. So the class survives a restart of the teacher's machine."""

from __future__ import annotations

import hashlib
import hmac
import json
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.classroom.errors import ClassroomError, NoClassError
from zbot.classroom.teacher.student_list import Register, Student
from zbot.json_reader import read_json_object
from zbot.security.secret import make_private_folder, write_private
from zbot.transport.membership import folder

if TYPE_CHECKING:
    from pathlib import Path

#: Maximum number of notices that are kept for students who join later.
MAX_NOTICES = 20
_ID_DIGITS = 31  # digits after the first: Zenoh's ids have 16 bytes, which are 32 hex digits


class RecordError(ClassroomError, ValueError):
    """The file of an open class is damaged."""

    def __init__(self, path: Path, reason: str) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"cannot read {path} ({reason}): remove it with `zbot class stop`")


class Identity(NamedTuple):
    """Identity of one owner of a number. The teacher's hub accepts the owner's laptop with it."""

    user: str
    secret: str
    hub_id: str  #: Zenoh id of the laptop's hub in lower-case hex digits. It begins with `f`


@dataclass
class ClassRecord:
    """Data of an open class."""

    name: str
    master: str = field(repr=False)  #: the key from which all secrets are derived
    pin: str = field(default="", repr=False)
    keystore: str = ""  #: folder of the teacher's certificate (empty without certificates)
    register: Register = field(default_factory=Register)
    is_open: bool = False  #: whether students may publish in the shared space
    shares: list[tuple[int, int]] = field(default_factory=list)  #: (owner, reader) of a domain
    notices: list[dict[str, Any]] = field(default_factory=list)
    holders: dict[int, str] = field(default_factory=dict)  #: the machine that has a number's secret
    renewals: dict[int, int] = field(default_factory=dict)  #: how often a number was renewed

    def assign(self, number: int, machine: str) -> bool:
        """Assign a number to a machine. If another machine knows the number's secret, renew it.

        Returns:
            Whether the secret was renewed.
        """
        is_new = self.holders.get(number, machine) != machine
        if is_new:
            self.renew(number)
        self.holders[number] = machine
        return is_new

    def renew(self, number: int) -> None:
        """Give a number its next identity. The identity of the number's former owner ends."""
        self.renewals[number] = self.renewals.get(number, 0) + 1
        self.holders.pop(number, None)

    def begin_period(self, expected: dict[int, str]) -> None:
        """Forget the students, what they share, and the notices. Keep the class's name and PIN.

        Args:
            expected: Names of the students of the new period, by number.
        """
        for number in list(self.holders):
            self.renew(number)
        # The register stays the same object, because the admission service uses it too.
        self.register.students, self.register.expected = {}, expected
        self.shares, self.notices, self.is_open = [], [], False

    def secret_of(self, user: str) -> str:
        """Return a user's secret. Calls with the same name return the same secret."""
        return hmac.new(self.master.encode(), user.encode(), hashlib.sha256).hexdigest()

    def identity(self, number: int, renewals: int) -> Identity:
        """Return the identity that a number has after some renewals."""
        user = user_of(number) + f"-{renewals}" * bool(renewals)
        hub_id = "f" + self.secret_of(f"hub of {user}")[:_ID_DIGITS]
        return Identity(user, self.secret_of(user), hub_id)

    def credentials(self, number: int) -> dict[str, str]:
        """Return the credentials with which the teacher's hub accepts a student's laptop.

        With a PIN, the credentials are the id of the laptop's hub, a user name and a secret.
        Without a PIN, they are only the id, because a Zenoh program then needs no secret.
        """
        found = self.identity(number, self.renewals.get(number, 0))._asdict()
        return found if self.pin else {"hub_id": found["hub_id"]}

    def save(self) -> None:
        """Write the file of the class. Only the file's owner can read it."""
        make_private_folder(folder())
        write_private(record_path(), json.dumps(asdict(self), indent=1).encode())


def user_of(number: int) -> str:
    """Return a student's user name."""
    return f"student{number}"


def record_path() -> Path:
    """Return the file of the open class."""
    return folder() / "class.json"


def load_record() -> ClassRecord:
    """Return the open class.

    Raises:
        NoClassError: No class is open.
        RecordError: The file is damaged.
    """
    path = record_path()
    try:
        return _parsed(read_json_object(path.read_text(encoding="utf-8")))
    except FileNotFoundError as exc:
        raise NoClassError from exc
    except (OSError, ValueError, TypeError, KeyError, AttributeError) as exc:
        raise RecordError(path, str(exc)) from exc


def _parsed(document: dict[str, Any]) -> ClassRecord:
    register = document.pop("register")
    students = {int(number): Student(**one) for number, one in register["students"].items()}
    expected = {int(number): name for number, name in register["expected"].items()}
    shares = [(int(owner), int(reader)) for owner, reader in document.pop("shares")]
    for name in ("holders", "renewals"):
        document[name] = {int(number): value for number, value in document[name].items()}
    return ClassRecord(register=Register(expected, students), shares=shares, **document)
