from __future__ import annotations

import pytest

from zbot.classroom.teacher.student_list import (
    FullClassError,
    NumberError,
    Register,
    SimilarNameError,
    TakenError,
)


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
