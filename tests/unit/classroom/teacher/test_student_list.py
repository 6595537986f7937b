from __future__ import annotations

import json

import pytest

from zbot.classroom.errors import ClassroomError, ClassValueError, RefusedError
from zbot.classroom.join_request import JoinRequest
from zbot.classroom.teacher import student_list
from zbot.classroom.teacher.student_list import StudentList


@pytest.fixture
def students() -> StudentList:
    return StudentList("master", {3: "Ana", 5: "Ben"})


def test_numbers_begin_at_one_and_skip_those_of_the_list(students: StudentList) -> None:
    given = [students.admit(JoinRequest(f"laptop{k}", "host")).number for k in range(4)]
    assert given == [1, 2, 4, 6]


def test_a_name_of_the_list_gets_its_number(students: StudentList) -> None:
    assert students.admit(JoinRequest("laptop", "host", "ana")).number == 3


def test_a_number_of_the_list_gets_its_name(students: StudentList) -> None:
    assert students.admit(JoinRequest("laptop", "host", None, 5)).name == "Ben"


def test_a_number_of_the_list_is_reserved_for_its_name(students: StudentList) -> None:
    with pytest.raises(RefusedError, match="taken by Ana"):
        students.admit(JoinRequest("laptop", "host", "Eve", 3))


def test_a_taken_number_is_refused_with_its_holders_name(students: StudentList) -> None:
    students.admit(JoinRequest("first", "host", "Cem", 17))
    with pytest.raises(RefusedError, match="number 17 is taken by Cem"):
        students.admit(JoinRequest("second", "host", "Eve", 17))


def test_a_laptop_that_returns_keeps_its_number(students: StudentList) -> None:
    first = students.admit(JoinRequest("laptop", "host", "Cem"))
    assert students.admit(JoinRequest("laptop", "host", "Cem")).number == first.number
    assert len(students.students()) == 1


def test_a_laptop_that_changes_its_number_frees_the_old_one(students: StudentList) -> None:
    students.admit(JoinRequest("laptop", "host", "Cem", 17))
    students.admit(JoinRequest("laptop", "host", "Cem", 18))
    assert [student.number for student in students.students()] == [18]
    assert students.admit(JoinRequest("second", "host", "Eve", 17)).number == 17


def test_a_freed_number_can_be_claimed(students: StudentList) -> None:
    students.admit(JoinRequest("first", "host", "Cem", 17))
    freed = students.free(17)
    assert freed is not None
    assert freed.name == "Cem"
    assert students.admit(JoinRequest("second", "host", "Eve", 17)).name == "Eve"
    assert students.free(99) is None


@pytest.mark.parametrize("number", [0, -1, 233, 10**9])
def test_numbers_are_domains(students: StudentList, number: int) -> None:
    with pytest.raises(ClassValueError, match="from 1 to 232"):
        students.admit(JoinRequest("laptop", "host", None, number))


def test_a_claim_after_the_last_number_is_refused() -> None:
    students = StudentList("master")
    numbers = [students.admit(JoinRequest(f"laptop{k}", "host")).number for k in range(232)]
    assert sorted(numbers) == list(range(1, 233))
    with pytest.raises(ClassroomError):
        students.admit(JoinRequest("one more", "host"))


def test_a_name_that_is_similar_to_one_of_the_list_is_a_question(students: StudentList) -> None:
    with pytest.raises(RefusedError, match='no "Anna", but "Ana"'):
        students.admit(JoinRequest("laptop", "host", "Anna"))
    assert students.admit(JoinRequest("laptop", "host", "Anna", is_new=True)).name == "Anna"
    assert students.admit(JoinRequest("other", "host", "ANA")).number == 3
    assert students.admit(JoinRequest("third", "host", "Anne")).number == 2  # Ana is here already


def test_a_laptop_that_returns_with_a_similar_name_is_asked_too(students: StudentList) -> None:
    students.admit(JoinRequest("laptop", "host", "Ana"))
    with pytest.raises(RefusedError):
        students.admit(JoinRequest("laptop", "host", "Anna"))


def test_laptops_with_equal_host_names_get_different_names() -> None:
    students = StudentList("master")
    names = [students.admit(JoinRequest(f"laptop{k}", "lab-pc")).name for k in range(30)]
    assert names[:3] == ["lab-pc", "lab-pc-2", "lab-pc-3"]
    assert len(set(names)) == 30
    assert students.admit(JoinRequest("laptop0", "lab-pc")).name == "lab-pc"


def test_the_list_is_the_same_after_a_restart(students: StudentList) -> None:
    for machine in ("first", "second"):
        student = students.admit(JoinRequest(machine, "host", "Ana"))
        students.free(3)
    students.admit(JoinRequest("second", "host", "Ana"))
    again = StudentList.of(json.loads(json.dumps(students.document())))
    assert again.document() == students.document()
    assert again.identity(3) == students.identity(3) == students.identity(3, 1)
    assert (student.number, again.missing()) == (3, {5: "Ben"})


def test_a_laptop_that_is_not_seen_again_is_not_here(
    students: StudentList, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in (3, 5):
        students.note_seen(number, is_here=True)
    students.expect_return()
    students.note_seen(5, is_here=True)
    assert students.here() == [3, 5]
    monkeypatch.setattr(student_list, "_RETURN_S", -1.0)
    students.expect_return()
    students.note_seen(5, is_here=True)
    assert students.here() == [5]


def test_a_laptop_that_joins_again_is_still_here(students: StudentList) -> None:
    number = students.admit(JoinRequest("laptop", "host")).number
    students.note_seen(number, is_here=True)
    students.admit(JoinRequest("laptop", "host"))
    assert students.here() == [number]
