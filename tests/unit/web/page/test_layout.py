"""Tests of layouts of panels: what a file may have, and how tiles move."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.web.page.layout import Layout, LayoutError, read_layout, read_layout_file

if TYPE_CHECKING:
    from pathlib import Path

PANELS = ["graph", "topics", "plot", "console", "view"]
#: The rows `a b`, `c` and `d e`.
ROWS = (("a", "b"), ("c",), ("d", "e"))


def rows(layout: Layout) -> str:
    """Return the rows as a short text, e.g. `ab c de`."""
    return " ".join("".join(row) for row in layout.rows)


def test_a_layout_is_read_and_written() -> None:
    text = '{"title": "Lesson 3", "rows": [["view", "plot?curve=/pose.x"], ["console"]]}'
    layout = read_layout(text, PANELS)
    assert layout.title == "Lesson 3"
    assert layout.rows == (("view", "plot?curve=/pose.x"), ("console",))
    assert read_layout(layout.text(), PANELS) == layout
    assert read_layout(layout.file_text(), PANELS) == layout


def test_addresses_have_one_form() -> None:
    text = '{"rows": [["plot?curve=%2Fscan.ranges%5B0%5D&a=%26", "topics?"]]}'
    assert read_layout(text, PANELS).rows == (("plot?curve=/scan.ranges[0]&a=%26", "topics"),)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "this is not valid JSON: Expecting value"),
        ("[]", "this is not valid JSON: it is not an object"),
        ("{}", "`rows` must be a list of rows"),
        ('{"rows": ["graph"]}', "`rows` must be a list of rows"),
        ('{"rows": [[]]}', "`rows` must be a list of rows"),
        ('{"rows": [["graph", 5]]}', 'row 1 must have names of panels, not ["graph", 5]'),
        ('{"rows": [["grahp"]]}', "there is no panel 'grahp'"),
        ('{"rows": [["/graph"]]}', "there is no panel '/graph'"),
        ('{"rows": [["//evil.example/graph"]]}', "there is no panel"),
        ('{"rows": [["layout"]]}', "there is no panel 'layout'"),
        ('{"row": [["graph"]]}', "a layout has no key 'row'"),
        ('{"title": 5, "rows": [["graph"]]}', "`title` must be a text"),
        ('{"rows": [["graph", "graph", "graph", "graph", "graph"]]}', "row 1 has 5 panels"),
        ('{"rows": [["graph"],["graph"],["graph"],["graph"],["graph"],["graph"],["graph"]]}',
         "at most 6 rows, not 7"),
    ],
)  # fmt: skip
def test_a_mistake_is_told_in_one_sentence(text: str, sentence: str) -> None:
    with pytest.raises(LayoutError) as caught:
        read_layout(text, PANELS)
    assert sentence in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_wrong_name_has_a_suggestion(tmp_path: Path) -> None:
    path = tmp_path / "lesson.json"
    path.write_text('{"rows": [["grahp"]]}', encoding="utf-8")
    with pytest.raises(LayoutError, match=r"lesson\.json: there is no panel 'grahp'") as caught:
        read_layout_file(path, PANELS)
    assert caught.value.hint == "did you mean 'graph'?"


def test_a_file_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    with pytest.raises(LayoutError, match=r"cannot read the layout .*lost"):
        read_layout_file(tmp_path / "lost.json", PANELS)
    (tmp_path / "latin").write_bytes(b"\xff")
    with pytest.raises(LayoutError, match="it is not UTF-8"):
        read_layout_file(tmp_path / "latin", PANELS)


@pytest.mark.parametrize(
    ("row", "place", "step", "moved"),
    [
        (0, 0, 1, "ba c de"),
        (0, 1, 1, "ab c de"),
        (0, 0, -1, "ab c de"),
        (2, 1, -1, "ab c ed"),
    ],
)
def test_a_tile_moves_sideways(row: int, place: int, step: int, moved: str) -> None:
    assert rows(Layout(ROWS).moved_sideways(row, place, step)) == moved


@pytest.mark.parametrize(
    ("row", "place", "up", "down"),
    [
        (0, 0, "a b c de", "b ca de"),
        (0, 1, "b a c de", "a cb de"),
        (1, 0, "abc de", "ab dec"),
        (2, 0, "ab cd e", "ab c e d"),
        (2, 1, "ab ce d", "ab c d e"),
    ],
)
def test_a_tile_moves_to_the_row_above_or_below(row: int, place: int, up: str, down: str) -> None:
    assert rows(Layout(ROWS).moved_up(row, place)) == up
    assert rows(Layout(ROWS).moved_down(row, place)) == down


def test_a_tile_alone_at_the_edge_stays() -> None:
    layout = Layout((("a",), ("b",)))
    assert layout.moved_up(0, 0) is layout
    assert layout.moved_down(1, 0) is layout


def test_tiles_are_added_until_the_layout_is_full() -> None:
    layout = Layout()
    found = []
    for name in "abc":
        layout = layout.with_tile(name)
        found.append(rows(layout))
    assert found == ["a", "ab", "ab c"]
    while not layout.is_full:
        layout = layout.with_tile("x")
    assert rows(layout) == "ab cx xx xx xx xx"
    assert layout.with_tile("y") is layout
    full = Layout((("a", "b", "c", "d"), ("e",)))
    assert full.moved_up(1, 0) is full


def test_a_tile_is_closed_or_gets_another_address() -> None:
    layout = Layout(ROWS)
    assert rows(layout.without(0, 0)) == "b c de"
    assert rows(layout.without(1, 0)) == "ab de"
    assert rows(layout.with_address(2, 1, "f")) == "ab c df"


def test_a_layout_that_is_too_long_to_be_read_again_keeps_its_former_tiles() -> None:
    layout = Layout((("plot", "graph"),)).with_address(0, 0, f"plot?curve={'x' * 7900}")
    assert read_layout(layout.text(), PANELS) == layout
    assert layout.with_address(0, 1, f"graph?topics={'x' * 100}") is layout
    assert layout.with_tile(f"topics?filter={'x' * 100}") is layout
    assert layout.with_address(0, 0, "plot").rows == (("plot", "graph"),)
