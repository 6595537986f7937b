"""Register of a class: the numbers that laptops have claimed, and the teacher's list of students.

This module does not use the network.
"""

from __future__ import annotations

import secrets
from dataclasses import dataclass, field

from zbot.classroom.errors import ClassroomError
from zbot.errors.suggestion import nearest
from zbot.transport.config import MAX_DOMAIN_ID

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
