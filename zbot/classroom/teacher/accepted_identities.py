"""Identities that the open hub of a class accepts: those of all owners, and of the next owners.

Zenoh reads users and access rules when a session opens. So the hub knows the identities of the next
owners of each number in advance. When a number gets another owner, the hub stays open, and the
links of the other students stay as they are.

The rules demand the user name and the hub's id of an identity. So a former owner can use its
identity only with the hub's id that the class knows. As soon as the class sees this id, it opens
the hub again, and the hub does not accept the identity any more.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.classroom.teacher.student import user_of
from zbot.classroom.teacher.student_number import NUMBERS
from zbot.security.access import LOBBY, LOBBY_SECRET, TEACHER

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.classroom.teacher.student import Identity
    from zbot.classroom.teacher.student_list import StudentList

# Number of next owners that the hub knows. An identity takes 56 kB of the hub's memory, and it
# takes 0.2 ms longer to open the hub. So the numbers that a class usually needs get more than the
# others. If a number has more owners, the hub is opened again.
_NEXT_OWNERS = 8
_FEW_NEXT_OWNERS = 1
_USUAL_NUMBERS = range(1, 41)
# The names of the loopback interface on Linux, macOS and Windows.
_LOOPBACK_INTERFACES = ("lo", "lo0", "Loopback Pseudo-Interface 1")


class AcceptedIdentities:
    """Identities that a hub accepts from now until it is opened again.

    Args:
        students: The list of the class. Numbers may get other owners later.
        has_pin: Whether students need a user name and a secret.
    """

    def __init__(self, students: StudentList, *, has_pin: bool) -> None:
        self._list = students
        self._has_pin = has_pin
        self._first = students.renewals()  # the renewals of each number now

    def _of(self, number: int) -> list[Identity]:
        first = self._first.get(number, 0)
        return [self._list.identity(number, first + turn) for turn in range(1 + _later(number))]

    def accepts(self, number: int) -> bool:
        """Return whether the hub accepts the present owner of a number."""
        first = self._first.get(number, 0)
        return self._list.renewals().get(number, 0) <= first + _later(number)

    def former_hub_ids(self) -> set[str]:
        """Return the ids of the hubs of former owners that the hub still accepts."""
        return {
            self._list.identity(number, turn).hub_id
            for number, renewals in self._list.renewals().items()
            for turn in range(self._first.get(number, 0), renewals)
        }

    def users(self) -> Iterator[tuple[str, str]]:
        """Yield the name and the secret of every user of the hub."""
        yield LOBBY, LOBBY_SECRET.reveal()
        yield TEACHER, self._list.secret_of(TEACHER)
        for number in NUMBERS:
            for identity in self._of(number):
                yield identity.user, identity.secret

    def apply(self, access: dict[str, Any]) -> None:
        """Let the access rules of each number count for all identities of the number.

        Args:
            access: The value of Zenoh's `access_control`. Its subjects are students, the teacher
                and the lobby.
        """
        numbers = {user_of(number): number for number in NUMBERS}
        subjects: dict[str, list[dict[str, Any]]] = {}
        for subject in access["subjects"]:
            user = subject["id"]
            number = numbers.get(user)
            subjects[user] = self._others(subject) if number is None else self._students(number)
        access["subjects"] = [subject for found in subjects.values() for subject in found]
        for policy in access["policies"]:
            found = [subject for user in policy["subjects"] for subject in subjects[user]]
            policy["subjects"] = [subject["id"] for subject in found]

    def _students(self, number: int) -> list[dict[str, Any]]:
        if self._has_pin:
            return [
                {"id": identity.user, "usernames": [identity.user], "zids": [identity.hub_id]}
                for identity in self._of(number)
            ]
        return [{"id": user_of(number), "zids": [identity.hub_id for identity in self._of(number)]}]

    def _others(self, subject: dict[str, Any]) -> list[dict[str, Any]]:
        if self._has_pin:
            return [subject]
        user = subject["id"]
        if user == TEACHER:
            return [{"id": user, "interfaces": list(_LOOPBACK_INTERFACES)}]
        return [{"id": user}]  # the rules of the user `lobby` apply to everybody


def _later(number: int) -> int:
    return _NEXT_OWNERS if number in _USUAL_NUMBERS else _FEW_NEXT_OWNERS
