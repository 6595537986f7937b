"""Number and name of a student who joins a class. This module does not use the network."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.classroom.errors import ClassroomError, ClassValueError, RefusedError
from zbot.classroom.teacher.student import Student
from zbot.errors.suggestion import nearest
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.classroom.join_request import JoinRequest

NUMBERS = range(1, MAX_DOMAIN_ID + 1)  #: all numbers that a class can give, which are domains


def validated_number(value: object) -> int:
    """Return a student's number.

    Raises:
        ClassValueError: The value is not a number from 1 to 232.
    """
    if not isinstance(value, int) or value not in NUMBERS:
        raise ClassValueError(
            f"a student's number must be from 1 to {MAX_DOMAIN_ID}, not {value!r}"
        )
    return value


def student_for(
    request: JoinRequest, students: Mapping[int, Student], expected: Mapping[int, str]
) -> Student:
    """Return the student whom a request makes, with a number and a name.

    A laptop that asks for no number keeps its number. If it has none, it gets the student's number
    in the teacher's list, else the lowest free number. A student without a name gets the name in
    the list, else the host name. If another student has this host name, the number is added.

    Args:
        request: The request of the student's laptop.
        students: The students who have joined, by number.
        expected: The names that the teacher expects, by number.

    Raises:
        ClassValueError: The number is out of range.
        RefusedError: Another laptop has the number, or the list keeps it for another name. Its
            kind is `taken`. Or the name is not in the list, but a similar name is, and no other
            laptop has the number of the similar name. The kind is `similar`.
        ClassroomError: No number is free.
    """
    name = request.name
    if name and not request.is_new:
        _check_similar(name, request.machine, students, expected)
    number = _number(request, students, expected)
    owner = students.get(number)
    if owner is not None and owner.machine != request.machine:
        raise _taken_error(number, owner.name)
    kept_for = expected.get(number)
    if kept_for and name and name.casefold() != kept_for.casefold():
        raise _taken_error(number, kept_for)
    shown = kept_for or name or _name_of_host(request.host, number, students)
    return Student(number, shown, request.machine, request.host)


def _taken_error(number: int, holder: str) -> RefusedError:
    return RefusedError(
        "taken",
        f"number {number} is taken by {holder}: choose another with --number, leave --number "
        "out, or ask the teacher to free it with `zbot class free NUMBER`",
    )


def _check_similar(
    name: str, machine: str, students: Mapping[int, Student], expected: Mapping[int, str]
) -> None:
    missing = {
        listed.casefold(): listed
        for number, listed in expected.items()
        if number not in students or students[number].machine == machine
    }
    everybody = {listed.casefold() for listed in expected.values()}
    guess = nearest(name.casefold(), missing)
    if guess is not None and name.casefold() not in everybody:
        known = missing[guess]
        text = f'the teacher\'s list has no "{name}", but "{known}": type --name "{known}", '
        raise RefusedError("similar", text + "or add --new-student if you are somebody else", known)


def _name_of_host(host: str, number: int, students: Mapping[int, Student]) -> str:
    """Return the name of a student without a name. Laptops may have equal host names."""
    others = {student.name for student in students.values() if student.number != number}
    return f"{host}-{number}" if host in others else host


def _number(
    request: JoinRequest, students: Mapping[int, Student], expected: Mapping[int, str]
) -> int:
    if request.number is not None:
        return validated_number(request.number)
    for student in students.values():
        if student.machine == request.machine:
            return student.number
    for number, listed in expected.items():
        if request.name and request.name.casefold() == listed.casefold():
            return number
    free = (number for number in NUMBERS if number not in students and number not in expected)
    found = next(free, None)
    if found is None:
        raise ClassroomError(f"the class is full: all {MAX_DOMAIN_ID} numbers are taken")
    return found
