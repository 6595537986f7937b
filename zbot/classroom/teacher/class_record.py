"""Record of an open class, in a file. So the class survives a restart of the teacher's machine."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import ClassValueError, no_class_error
from zbot.classroom.teacher.student_list import StudentList
from zbot.security.secret import make_private_folder, write_private
from zbot.text.json_reader import read_json_object
from zbot.transport.membership import folder

if TYPE_CHECKING:
    from pathlib import Path

#: Maximum number of notices that are kept for students who join later.
MAX_NOTICES = 20


@dataclass
class ClassRecord:
    """Data of an open class."""

    name: str
    students: StudentList
    pin: str = field(default="", repr=False)
    keystore: str = ""  #: folder of the teacher's certificate (empty without certificates)
    is_open: bool = False  #: whether students may publish in the shared space
    has_sensors: bool = True  #: whether pages may publish the sensors of browsers
    shares: list[tuple[int, int]] = field(default_factory=list)  #: (owner, reader) of a domain
    notices: list[dict[str, Any]] = field(default_factory=list)

    def begin_period(self, expected: dict[int, str]) -> None:
        """Forget the students, what they share, and the notices. Keep the class's name and PIN.

        Args:
            expected: Names of the students of the new period, by number.
        """
        self.students.begin_period(expected)
        self.shares, self.notices, self.is_open = [], [], False

    def document(self) -> dict[str, Any]:
        """Return the data for the file. They contain all secrets of the class."""
        own = {part.name: getattr(self, part.name) for part in fields(self)}
        del own["students"]
        return own | self.students.document()

    def save(self) -> None:
        """Write the file of the class. Only the file's owner can read it."""
        make_private_folder(folder())
        write_private(record_path(), json.dumps(self.document(), indent=1).encode())


def record_path() -> Path:
    """Return the file of the open class."""
    return folder() / "class.json"


def load_record() -> ClassRecord:
    """Return the open class.

    Raises:
        ClassroomError: No class is open.
        ClassValueError: The file is damaged.
    """
    path = record_path()
    try:
        return _parsed(read_json_object(path.read_text(encoding="utf-8")))
    except FileNotFoundError as exc:
        raise no_class_error() from exc
    except (OSError, ValueError, TypeError, KeyError, AttributeError) as exc:
        raise ClassValueError(
            f"cannot read {path} ({exc!s}): remove it with `zbot class stop`"
        ) from exc


def _parsed(document: dict[str, Any]) -> ClassRecord:
    students = StudentList.of(document)
    shares = [(int(owner), int(reader)) for owner, reader in document.pop("shares")]
    return ClassRecord(students=students, shares=shares, **document)
