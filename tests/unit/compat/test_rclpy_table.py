"""docs/rclpy.md says what is there."""

from __future__ import annotations

from tests.unit.compat.rclpy_table import TABLE, table


def test_the_page_is_true() -> None:
    assert TABLE.read_text(encoding="utf-8") == table()


def test_what_is_absent_has_a_reason() -> None:
    assert [line for line in table().splitlines() if line.endswith("| absent |  |")] == []
