from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.classroom.errors import ClassValueError
from zbot.classroom.teacher.roster import load_roster, read_roster

if TYPE_CHECKING:
    from pathlib import Path


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
    with pytest.raises(ClassValueError, match=reason):
        read_roster(text)


def test_a_missing_list_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ClassValueError, match="No such file"):
        load_roster(tmp_path / "nowhere.csv")


def test_a_roster_with_an_odd_line_end_is_one_error() -> None:
    with pytest.raises(ClassValueError, match="line 1 of the list"):
        read_roster("1,Ana\r2,Ben\n")


def test_a_roster_with_thousands_of_digits_is_one_error() -> None:
    with pytest.raises(ClassValueError, match="is not a number from 1 to 232") as caught:
        read_roster("9" * 5000 + ",Ana\n")
    assert len(str(caught.value)) < 300
