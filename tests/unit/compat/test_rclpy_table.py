"""Tests of docs/rclpy.md."""

from __future__ import annotations

from tests.unit.compat.rclpy_table import NAMES, TABLE, WHY, absent_members, find, table


def test_the_page_equals_the_generated_table() -> None:
    assert TABLE.read_text(encoding="utf-8") == table()


def test_every_absent_name_has_a_reason() -> None:
    absent = {
        member
        for module, names in NAMES.items()
        for name, members in names.items()
        for member in absent_members(find(module, name), members)
    }
    assert absent - set(WHY) == set()
