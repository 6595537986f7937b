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

from zbot.classroom.teacher.class_record import user_of
from zbot.security.access import LOBBY, LOBBY_SECRET, TEACHER
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.classroom.teacher.class_record import ClassRecord, Identity

NUMBERS = range(1, MAX_DOMAIN_ID + 1)
# Number of next owners that the hub knows. An identity takes 44 kB of the hub's memory, and it
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
        record: The class's data. Numbers may get other owners later.
    """

    def __init__(self, record: ClassRecord) -> None:
        self._record = record
        self._first = dict(record.renewals)  # the renewals of each number now

    def _of(self, number: int) -> list[Identity]:
        first = self._first.get(number, 0)
        return [self._record.identity(number, first + turn) for turn in range(1 + _later(number))]

    def accepts(self, number: int) -> bool:
        """Return whether the hub accepts the present owner of a number."""
        first = self._first.get(number, 0)
        return self._record.renewals.get(number, 0) <= first + _later(number)

    def former_hub_ids(self) -> set[str]:
        """Return the ids of the hubs of former owners that the hub still accepts."""
        return {
            self._record.identity(number, turn).hub_id
            for number, renewals in dict(self._record.renewals).items()
            for turn in range(self._first.get(number, 0), renewals)
        }

    def users(self) -> Iterator[tuple[str, str]]:
        """Yield the name and the secret of every user of the hub."""
        yield LOBBY, LOBBY_SECRET.reveal()
        yield TEACHER, self._record.secret_of(TEACHER)
        for number in NUMBERS:
            for one in self._of(number):
                yield one.user, one.secret

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
        access["subjects"] = [one for found in subjects.values() for one in found]
        for policy in access["policies"]:
            found = [one for user in policy["subjects"] for one in subjects[user]]
            policy["subjects"] = [one["id"] for one in found]

    def _students(self, number: int) -> list[dict[str, Any]]:
        if self._record.pin:
            return [
                {"id": one.user, "usernames": [one.user], "zids": [one.hub_id]}
                for one in self._of(number)
            ]
        return [{"id": user_of(number), "zids": [one.hub_id for one in self._of(number)]}]

    def _others(self, subject: dict[str, Any]) -> list[dict[str, Any]]:
        if self._record.pin:
            return [subject]
        user = subject["id"]
        if user == TEACHER:
            return [{"id": user, "interfaces": list(_LOOPBACK_INTERFACES)}]
        return [{"id": user}]  # the rules of the user `lobby` apply to everybody


def _later(number: int) -> int:
    return _NEXT_OWNERS if number in _USUAL_NUMBERS else _FEW_NEXT_OWNERS
