"""Register of a class: the numbers that laptops have claimed, and the teacher's list of students.

This module does not use the network.
"""

from __future__ import annotations

import csv
import io
import secrets
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.classroom.errors import ClassroomError
from zbot.errors import shortened
from zbot.errors.suggestion import nearest
from zbot.terminal.text import single_line
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from pathlib import Path

MAX_NAME_LENGTH = 64
MAX_SENTENCE_LENGTH = 500
_MAX_DIGITS = 9
_CLAIM_BYTES = 8


class TakenError(ClassroomError):
    """Another student has the number."""

    def __init__(self, number: int, holder: str) -> None:
        self.number, self.holder = number, holder
        super().__init__(
            f"number {number} is taken by {holder}: choose another with --number, leave --number "
            "out, or ask the teacher to free it with `zbot class free NUMBER`"
        )


class NumberError(ClassroomError, ValueError):
    """A student's number is out of range."""

    def __init__(self, number: object) -> None:
        self.number = number
        super().__init__(f"a student's number must be from 1 to {MAX_DOMAIN_ID}, not {number!r}")


class FullClassError(ClassroomError):
    """Every number is taken."""

    def __init__(self) -> None:
        super().__init__(f"the class is full: all {MAX_DOMAIN_ID} numbers are taken")


class SimilarNameError(ClassroomError, ValueError):
    """A name is not in the list of students, but a similar name is."""

    def __init__(self, name: str, known: str) -> None:
        self.name, self.known = name, known
        super().__init__(
            f'the teacher\'s list has no "{name}", but "{known}": type --name "{known}", '
            "or add --new-student if you are somebody else"
        )


class RosterError(ClassroomError, ValueError):
    """A list of students cannot be read."""

    def __init__(self, line: int, reason: str) -> None:
        self.line, self.reason = line, reason
        where = f"line {line} of the list of students" if line else "the list of students"
        super().__init__(f"{where}: {reason} (lines are: number,name)")


def clean_name(text: str) -> str:
    """Return a name that is safe to print: one line of at most 64 printable characters.

    Control characters and characters that change the direction of writing become spaces.
    """
    return single_line(text, MAX_NAME_LENGTH)


def clean_sentence(text: str) -> str:
    """Return a message from another machine as one line of at most 500 printable characters."""
    return single_line(text, MAX_SENTENCE_LENGTH)


@dataclass(frozen=True)
class Student:
    """A student who has joined."""

    number: int
    name: str
    machine: str  #: random text that identifies the laptop
    host: str  #: the laptop's host name
    claim: str = field(default_factory=lambda: secrets.token_hex(_CLAIM_BYTES))


@dataclass
class Register:
    """The numbers of a class."""

    expected: dict[int, str] = field(default_factory=dict)  #: names by number, from the teacher
    students: dict[int, Student] = field(default_factory=dict)

    def claim(
        self,
        number: int | None,
        name: str | None,
        machine: str,
        host: str,
        *,
        is_new: bool = False,
    ) -> Student:
        """Give a number to a laptop, and return the laptop's student.

        Args:
            number: The requested number. If it is `None`, the laptop keeps its number. A laptop
                with no number gets the student's number in the list, else the lowest free number.
            name: The student's name. If it is `None`, the name in the list is used, or else the
                host name. If another student already has this host name, the number is
                added to the host name.
            machine: The laptop's identifier.
            host: The laptop's host name.
            is_new: Whether a similar name in the list is another student.

        Raises:
            NumberError: The number is out of range.
            TakenError: Another laptop has the number, or the list keeps it for another name.
            FullClassError: No number is free.
            SimilarNameError: The name is not in the list, but a similar name is. No other laptop
                has the number of the similar name.
        """
        if name and not is_new:
            self._check_similar(name, machine)
        wanted = self._number(number, name, machine)
        holder = self.students.get(wanted)
        if holder is not None and holder.machine != machine:
            raise TakenError(wanted, holder.name)
        kept_for = self.expected.get(wanted)
        if kept_for and name and name.casefold() != kept_for.casefold():
            raise TakenError(wanted, kept_for)
        student = Student(wanted, kept_for or name or self._name(host, wanted), machine, host)
        # This makes a new dictionary, because another thread may iterate over the old dictionary.
        others = {n: one for n, one in self.students.items() if one.machine != machine}
        self.students = {**others, wanted: student}
        return student

    def _check_similar(self, name: str, machine: str) -> None:
        missing = {
            listed.casefold(): listed
            for number, listed in self.expected.items()
            if number not in self.students or self.students[number].machine == machine
        }
        everybody = {listed.casefold() for listed in self.expected.values()}
        guess = nearest(name.casefold(), missing)
        if guess is not None and name.casefold() not in everybody:
            raise SimilarNameError(name, missing[guess])

    def _name(self, host: str, number: int) -> str:
        """Return the name of a student without a name. Laptops may have equal host names."""
        others = {one.name for n, one in self.students.items() if n != number}
        return f"{host}-{number}" if host in others else host

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

    def namesakes(self, student: Student) -> list[int]:
        """Return the numbers of the other students who have the name of this student."""
        name = student.name.casefold()
        return sorted(
            number
            for number, one in self.students.items()
            if one.name.casefold() == name and number != student.number
        )

    def free(self, number: int) -> Student | None:
        """Free a number. Return the student who had it, or `None` if it was free."""
        freed = self.students.get(number)
        self.students = {n: one for n, one in self.students.items() if n != number}
        return freed


def load_roster(path: Path) -> dict[int, str]:
    """Return the names by number from a file with a list of students.

    Raises:
        RosterError: The file cannot be read, or has an error (see `read_roster`).
    """
    try:
        return read_roster(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError) as exc:
        raise RosterError(0, f"{path}: {getattr(exc, 'strerror', None) or exc}") from exc


def read_roster(text: str) -> dict[int, str]:
    """Return the names by number from a list of students.

    The list has lines of `number,name` or `number;name`, with or without a heading.

    Raises:
        RosterError: A line has no number from 1 to 232, or two lines have the same number.
    """
    found: dict[int, str] = {}
    for line, row in enumerate(_rows(text), 1):
        cells = [cell.strip() for cell in row]
        if not any(cells) or (line == 1 and not cells[0].isdigit()):
            continue
        number = int(cells[0]) if _is_short_number(cells[0]) else 0
        if not 1 <= number <= MAX_DOMAIN_ID:
            raise RosterError(
                line, f"{shortened(cells[0])} is not a number from 1 to {MAX_DOMAIN_ID}"
            )
        if number in found:
            raise RosterError(line, f"number {number} appears twice")
        found[number] = clean_name(" ".join(cells[1:]))
    return found


def _is_short_number(text: str) -> bool:
    # Python raises an error for thousands of digits.
    return text.isascii() and text.isdigit() and len(text) <= _MAX_DIGITS


def _rows(text: str) -> list[list[str]]:
    separator = ";" if text.count(";") > text.count(",") else ","
    rows = csv.reader(io.StringIO(text.lstrip("\ufeff")), delimiter=separator)
    try:
        return list(rows)
    except csv.Error as exc:
        raise RosterError(rows.line_num, str(exc)) from exc
