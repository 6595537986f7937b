from __future__ import annotations

import pytest

from zbot.classroom.join_request import JoinRequest
from zbot.classroom.teacher.accepted_identities import AcceptedIdentities
from zbot.classroom.teacher.class_record import ClassRecord
from zbot.classroom.teacher.student import Identity, user_of
from zbot.classroom.teacher.student_list import StudentList
from zbot.classroom.teacher.student_number import NUMBERS
from zbot.security.access import teacher_access


@pytest.fixture
def students() -> StudentList:
    return StudentList("master")


def assign(students: StudentList, machine: str) -> Identity:
    """Let a machine take number 7, and free it. Return the machine's identity."""
    students.admit(JoinRequest(machine, "host", number=7))
    students.free(7)
    return students.identity(7)


def accepted_by(students: StudentList, *, has_pin: bool = True) -> AcceptedIdentities:
    return AcceptedIdentities(students, has_pin=has_pin)


def subjects_of(accepted: AcceptedIdentities) -> dict[str, dict[str, object]]:
    """Return the subjects of the access rules, by the id of the subject."""
    access = teacher_access({user_of(number): number for number in NUMBERS})["access_control"]
    accepted.apply(access)
    known = {subject["id"] for subject in access["subjects"]}
    assert all(set(policy["subjects"]) <= known for policy in access["policies"])
    return {subject["id"]: subject for subject in access["subjects"]}


def test_the_next_owners_of_a_number_are_accepted_in_advance(students: StudentList) -> None:
    assign(students, "first")
    accepted = accepted_by(students)
    secrets = set()
    for turn in range(9):
        given = assign(students, f"laptop {turn}")
        assert accepted.accepts(7) == (turn < 8)
        assert ((given.user, given.secret) in set(accepted.users())) == (turn < 8)
        secrets.add(given.secret)
    assert len(secrets) == 9
    assert accepted_by(students).accepts(7)


def test_a_laptop_that_returns_to_its_number_keeps_its_identity(students: StudentList) -> None:
    assert assign(students, "first") == assign(students, "first")


def test_the_hub_of_a_former_owner_is_known(students: StudentList) -> None:
    former = assign(students, "first").hub_id
    accepted = accepted_by(students)
    assert accepted.former_hub_ids() == set()
    present = assign(students, "second").hub_id
    assert accepted.former_hub_ids() == {former}
    assert present not in accepted.former_hub_ids()
    assert accepted_by(students).former_hub_ids() == set()


def test_an_identity_needs_its_user_name_and_its_hub_id(students: StudentList) -> None:
    given, found = assign(students, "first"), subjects_of(accepted_by(students))
    assert found["student7"]["usernames"] == [given.user]
    assert found["student7"]["zids"] == [given.hub_id]
    assert found["student7-1"]["zids"] != found["student7"]["zids"]
    assert found["teacher"] == {"id": "teacher", "usernames": ["teacher"]}


def test_without_a_pin_the_hub_id_is_the_identity(students: StudentList) -> None:
    given = assign(students, "first")
    found = subjects_of(accepted_by(students, has_pin=False))
    assert given.hub_id in found["student7"]["zids"]  # type: ignore[operator]
    assert found["lobby"] == {"id": "lobby"}
    assert "interfaces" in found["teacher"]


def test_a_new_period_renews_the_numbers_that_somebody_had(students: StudentList) -> None:
    record = ClassRecord("Robots", students)
    had, other = assign(students, "first"), students.identity(8)
    record.shares, record.is_open, record.notices = [(7, 8)], True, [{"text": "x"}]
    record.begin_period({7: "Ana"})
    assert students.identity(7) != had
    assert students.identity(8) == other
    assert students.expected == {7: "Ana"}
    assert (record.shares, record.is_open, record.notices) == ([], False, [])
