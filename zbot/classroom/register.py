"""Who has which number: claims, what a list of students says, and the rules between the two.

Pure: numbers, names and machines in, students or refusals out.
"""

from __future__ import annotations

import csv
import io
import secrets
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.classroom.errors import ClassroomError
from zbot.terminal_text import plain
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from pathlib import Path

MAX_NAME_LENGTH = 64
MAX_SENTENCE_LENGTH = 500
_CLAIM_BYTES = 8


class TakenError(ClassroomError):
    """Somebody else has the number."""

    def __init__(self, number: int, holder: str) -> None:
        self.number, self.holder = number, holder
        super().__init__(
            f"number {number} is taken by {holder}: choose another with --number, or none "
            "(the teacher can free it: zbot class free NUMBER)"
        )


class NumberError(ClassroomError, ValueError):
    """A student's number is out of range."""

    def __init__(self, number: object) -> None:
        self.number = number
        super().__init__(f"a student's number is from 1 to {MAX_DOMAIN_ID}, not {number!r}")


class FullClassError(ClassroomError):
    """Every number is taken."""

    def __init__(self) -> None:
        super().__init__(f"the class is full: all {MAX_DOMAIN_ID} numbers are taken")


class RosterError(ClassroomError, ValueError):
    """A list of students cannot be read."""

    def __init__(self, line: int, reason: str) -> None:
        self.line, self.reason = line, reason
        where = f"line {line} of the list of students" if line else "the list of students"
        super().__init__(f"{where}: {reason} (lines are: number,name)")


def clean_name(text: str) -> str:
    """Return a name that can be shown anywhere: one line, nothing that moves a cursor, 64 at most.

    Control characters and those that turn the direction of writing become spaces.
    """
    return plain(text, MAX_NAME_LENGTH)


def clean_sentence(text: str) -> str:
    """Return a sentence of another machine as it may be shown: like names, with 500 at most."""
    return plain(text, MAX_SENTENCE_LENGTH)


@dataclass(frozen=True)
class Student:
    """Somebody who has joined."""

    number: int
    name: str
    machine: str  #: tells one laptop from another; random
    host: str  #: what the laptop calls itself
    claim: str = field(default_factory=lambda: secrets.token_hex(_CLAIM_BYTES))


@dataclass
class Register:
    """The numbers of a class."""

    expected: dict[int, str] = field(default_factory=dict)  #: names by number, from the teacher
    students: dict[int, Student] = field(default_factory=dict)

    def claim(self, number: int | None, name: str | None, machine: str, host: str) -> Student:
        """Give a number to a laptop; one that had a number before gets that again.

        Args:
            number: The one it asks for; `None` for that of its name in the list, else a free one.
            name: Of the student; `None` for what the list says, else that of the laptop.
            machine: Which laptop it is.
            host: What it calls itself.

        Raises:
            NumberError: It is out of range.
            TakenError: Somebody has it, or the list keeps it for somebody else.
            FullClassError: None is left.
        """
        wanted = self._number(number, name, machine)
        holder = self.students.get(wanted)
        if holder is not None and holder.machine != machine:
            raise TakenError(wanted, holder.name)
        kept_for = self.expected.get(wanted)
        if kept_for and name and name.casefold() != kept_for.casefold():
            raise TakenError(wanted, kept_for)
        student = Student(wanted, kept_for or name or host, machine, host)
        # A new dictionary: others may just look through the old one.
        others = {n: one for n, one in self.students.items() if one.machine != machine}
        self.students = {**others, wanted: student}
        return student

    def _number(self, number: int | None, name: str | None, machine: str) -> int:
        if number is not None:
            if not 1 <= number <= MAX_DOMAIN_ID:
                raise NumberError(number)
            return number
        for student in self.students.values():
            if student.machine == machine:
                return student.number
        for listed, known in self.expected.items():
            if name and name.casefold() == known.casefold():
                return listed
        taken = self.students.keys() | self.expected.keys()
        free = (one for one in range(1, MAX_DOMAIN_ID + 1) if one not in taken)
        found = next(free, None)
        if found is None:
            raise FullClassError
        return found

    def free(self, number: int) -> Student | None:
        """Take a number back; return who had it."""
        freed = self.students.get(number)
        self.students = {n: one for n, one in self.students.items() if n != number}
        return freed


def load_roster(path: Path) -> dict[int, str]:
    """Read the file of a list of students.

    Raises:
        RosterError: It cannot be read, or see `read_roster`.
    """
    try:
        return read_roster(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError) as exc:
        raise RosterError(0, f"{path}: {getattr(exc, 'strerror', None) or exc}") from exc


def read_roster(text: str) -> dict[int, str]:
    """Read a list of students: lines of `number,name`, with or without a heading.

    Raises:
        RosterError: A line has no number from 1 to 232, or one that another line has.
    """
    dialect = ";" if text.count(";") > text.count(",") else ","
    found: dict[int, str] = {}
    for line, row in enumerate(
        csv.reader(io.StringIO(text.lstrip("\ufeff")), delimiter=dialect), 1
    ):
        cells = [cell.strip() for cell in row]
        if not any(cells) or (line == 1 and not cells[0].isdigit()):
            continue
        number = int(cells[0]) if cells[0].isascii() and cells[0].isdigit() else 0
        if not 1 <= number <= MAX_DOMAIN_ID:
            raise RosterError(line, f"{cells[0]!r} is no number from 1 to {MAX_DOMAIN_ID}")
        if number in found:
            raise RosterError(line, f"number {number} is there twice")
        found[number] = clean_name(" ".join(cells[1:]))
    return found
