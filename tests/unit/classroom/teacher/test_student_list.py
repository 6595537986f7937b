from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.classroom.teacher.student_list import (
    FullClassError,
    NumberError,
    Register,
    RosterError,
    SimilarNameError,
    TakenError,
    clean_name,
    load_roster,
    read_roster,
)

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture
def register() -> Register:
    return Register({3: "Ana", 5: "Ben"})


def test_numbers_begin_at_one_and_skip_those_of_the_list(register: Register) -> None:
    given = [register.claim(None, None, f"laptop{k}", "host").number for k in range(4)]
    assert given == [1, 2, 4, 6]


def test_a_name_of_the_list_gets_its_number(register: Register) -> None:
    assert register.claim(None, "ana", "laptop", "host").number == 3


def test_a_number_of_the_list_gets_its_name(register: Register) -> None:
    assert register.claim(5, None, "laptop", "host").name == "Ben"


def test_a_number_of_the_list_is_reserved_for_its_name(register: Register) -> None:
    with pytest.raises(TakenError, match="taken by Ana"):
        register.claim(3, "Eve", "laptop", "host")


def test_a_taken_number_is_refused_with_its_holders_name(register: Register) -> None:
    register.claim(17, "Cem", "first", "host")
    with pytest.raises(TakenError, match="number 17 is taken by Cem"):
        register.claim(17, "Eve", "second", "host")


def test_a_laptop_that_returns_keeps_its_number(register: Register) -> None:
    first = register.claim(None, "Cem", "laptop", "host")
    assert register.claim(None, "Cem", "laptop", "host").number == first.number
    assert len(register.students) == 1


def test_a_laptop_that_changes_its_number_frees_the_old_one(register: Register) -> None:
    register.claim(17, "Cem", "laptop", "host")
    register.claim(18, "Cem", "laptop", "host")
    assert list(register.students) == [18]
    assert register.claim(17, "Eve", "second", "host").number == 17


def test_a_freed_number_can_be_claimed(register: Register) -> None:
    register.claim(17, "Cem", "first", "host")
    freed = register.free(17)
    assert freed is not None
    assert freed.name == "Cem"
    assert register.claim(17, "Eve", "second", "host").name == "Eve"
    assert register.free(99) is None


@pytest.mark.parametrize("number", [0, -1, 233, 10**9])
def test_numbers_are_domains(register: Register, number: int) -> None:
    with pytest.raises(NumberError, match="from 1 to 232"):
        register.claim(number, None, "laptop", "host")


def test_a_claim_after_the_last_number_is_refused() -> None:
    register = Register()
    numbers = [register.claim(None, None, f"laptop{k}", "host").number for k in range(232)]
    assert sorted(numbers) == list(range(1, 233))
    with pytest.raises(FullClassError):
        register.claim(None, None, "one more", "host")


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("Ana", "Ana"),
        ("  Ana \t Müller\n", "Ana Müller"),
        ("\x1b[2JAna", "[2JAna"),
        ("Ana\u202egnp.exe", "Ana gnp.exe"),
        ("A" * 100, "A" * 64),
        ("\x00\x07", ""),
        ("<b>Ana</b>", "<b>Ana</b>"),
    ],
)
def test_names_are_one_line_without_control_characters(name: str, shown: str) -> None:
    assert clean_name(name) == shown


def test_a_list_of_students_is_read(tmp_path: Path) -> None:
    path = tmp_path / "roster.csv"
    path.write_text("\ufeffnumber,name\n17, Ana Müller\n\n18,Ben\n", encoding="utf-8")
    assert load_roster(path) == {17: "Ana Müller", 18: "Ben"}


def test_a_list_may_have_semicolons_and_no_header() -> None:
    assert read_roster('1;"Ana"\n2;Ben\n') == {1: "Ana", 2: "Ben"}


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("1,Ana\n1,Ben", "line 2 .* number 1 appears twice"),
        ("1,Ana\nBen,2", "line 2 .* 'Ben' is not a number"),
        ("0,Ana", "line 1 .* '0' is not a number"),
        ("1,Ana\n233,Ben", "'233' is not a number from 1 to 232"),
    ],
)
def test_an_invalid_list_is_refused_with_the_line(text: str, reason: str) -> None:
    with pytest.raises(RosterError, match=reason):
        read_roster(text)


def test_a_missing_list_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RosterError, match="No such file"):
        load_roster(tmp_path / "nowhere.csv")


def test_a_roster_with_an_odd_line_end_is_one_error() -> None:
    with pytest.raises(RosterError, match="line 1 of the list"):
        read_roster("1,Ana\r2,Ben\n")


def test_a_roster_with_thousands_of_digits_is_one_error() -> None:
    with pytest.raises(RosterError, match="is not a number from 1 to 232") as caught:
        read_roster("9" * 5000 + ",Ana\n")
    assert len(str(caught.value)) < 300


def test_a_name_that_is_similar_to_one_of_the_list_is_a_question(register: Register) -> None:
    with pytest.raises(SimilarNameError, match='no "Anna", but "Ana"'):
        register.claim(None, "Anna", "laptop", "host")
    assert register.claim(None, "Anna", "laptop", "host", is_new=True).name == "Anna"
    assert register.claim(None, "ANA", "other", "host").number == 3
    assert register.claim(None, "Anne", "third", "host").number == 2  # Ana is here already


def test_a_laptop_that_returns_with_a_similar_name_is_asked_too(register: Register) -> None:
    register.claim(None, "Ana", "laptop", "host")
    with pytest.raises(SimilarNameError):
        register.claim(None, "Anna", "laptop", "host")


def test_laptops_with_equal_host_names_get_different_names() -> None:
    register = Register()
    names = [register.claim(None, None, f"laptop{k}", "lab-pc").name for k in range(30)]
    assert names[:3] == ["lab-pc", "lab-pc-2", "lab-pc-3"]
    assert len(set(names)) == 30
    assert register.claim(None, None, "laptop0", "lab-pc").name == "lab-pc"
