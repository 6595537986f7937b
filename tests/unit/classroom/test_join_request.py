from __future__ import annotations

import pytest

from zbot.classroom.join_request import clean_name


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
