"""Reader of the teacher's file of expected students: a number and a name in each line."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING

from zbot.classroom.errors import ClassValueError
from zbot.classroom.join_request import clean_name
from zbot.errors import shortened
from zbot.text.whole_number import whole_number
from zbot.transport.config import MAX_DOMAIN_ID

if TYPE_CHECKING:
    from pathlib import Path


def roster_error(line: int, reason: str) -> ClassValueError:
    """Return the error that a list of students cannot be read."""
    where = f"line {line} of the list of students" if line else "the list of students"
    return ClassValueError(f"{where}: {reason} (lines are: number,name)")


def load_roster(path: Path) -> dict[int, str]:
    """Return the names by number from a file with a list of students.

    Raises:
        ClassValueError: The file cannot be read, or has an error (see `read_roster`).
    """
    try:
        return read_roster(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError) as exc:
        raise roster_error(0, f"{path}: {getattr(exc, 'strerror', None) or exc}") from exc


def read_roster(text: str) -> dict[int, str]:
    """Return the names by number from a list of students.

    The list has lines of `number,name` or `number;name`, with or without a heading.

    Raises:
        ClassValueError: A line has no number from 1 to 232, or two lines have the same number.
    """
    found: dict[int, str] = {}
    for line, row in enumerate(_rows(text), 1):
        cells = [cell.strip() for cell in row]
        if not any(cells) or (line == 1 and not cells[0].isdigit()):
            continue
        number = whole_number(cells[0])
        if number is None or not 1 <= number <= MAX_DOMAIN_ID:
            raise roster_error(
                line, f"{shortened(cells[0])} is not a number from 1 to {MAX_DOMAIN_ID}"
            )
        if number in found:
            raise roster_error(line, f"number {number} appears twice")
        found[number] = clean_name(" ".join(cells[1:]))
    return found


def _rows(text: str) -> list[list[str]]:
    separator = ";" if text.count(";") > text.count(",") else ","
    rows = csv.reader(io.StringIO(text.lstrip("\ufeff")), delimiter=separator)
    try:
        return list(rows)
    except csv.Error as exc:
        raise roster_error(rows.line_num, str(exc)) from exc
