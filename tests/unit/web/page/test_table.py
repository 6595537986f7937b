"""Tests of the tables of the page."""

from __future__ import annotations

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.web.page.table import MOST_ROWS, first_rows


@pytest.mark.parametrize("count", [0, MOST_ROWS, MOST_ROWS + 7])
def test_a_table_shows_its_first_rows(count: int) -> None:
    rows = {f"/topic_{number}": number for number in range(count)}
    shown, more = first_rows(rows)
    assert list(shown) == list(rows)[:MOST_ROWS]
    assert more == count - len(shown)
