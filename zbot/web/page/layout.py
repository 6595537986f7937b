"""Layout of panels in rows: its form in files and addresses, and its changes."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, TypeAlias
from urllib.parse import parse_qsl, urlencode

from zbot.errors.suggestion import did_you_mean
from zbot.observer.errors import ViewerError
from zbot.text.json_reader import JsonError, read_json_object

if TYPE_CHECKING:
    from collections.abc import Collection
    from pathlib import Path

    #: The tiles of one row. A tile is the address of a panel: `topics` or `plot?curve=/pose.x`.
    Row: TypeAlias = tuple[str, ...]

_MOST_ROWS = 6
_MOST_IN_ROW = 4
_MOST_CHARACTERS = 8_000
_LONGEST_TITLE = 80
_KEYS = ("title", "rows")
_BARE = "/:,[]"  # these characters need no escapes in a query


class LayoutError(ViewerError):
    """A text is not a layout of panels."""


@dataclass(frozen=True, slots=True)
class Layout:
    """Panels in rows, from the top to the bottom, and in each row from the left to the right."""

    rows: tuple[Row, ...] = ()
    title: str = ""

    def text(self) -> str:
        """Return the layout as JSON, as short as possible, for an address."""
        document = {"title": self.title} if self.title else {}
        return json.dumps({**document, "rows": self.rows}, separators=(",", ":"))

    def file_text(self) -> str:
        """Return the layout as JSON for a file, with a line for each row."""
        rows = ",\n".join(f"    {json.dumps(row)}" for row in self.rows)
        title = f'  "title": {json.dumps(self.title)},\n' if self.title else ""
        return f'{{\n{title}  "rows": [\n{rows}\n  ]\n}}\n'

    def with_tile(self, address: str) -> Layout:
        """Return the layout with one more tile: in the last row if it has one, or in a new row."""
        if self.rows and len(self.rows[-1]) == 1:
            return self._with_rows(*self.rows[:-1], (*self.rows[-1], address))
        return self._with_rows(*self.rows, (address,))

    def without(self, row: int, place: int) -> Layout:
        """Return the layout without a tile."""
        return self._with_row(row, self.rows[row][:place] + self.rows[row][place + 1 :])

    def with_address(self, row: int, place: int, address: str) -> Layout:
        """Return the layout with another address in a tile, unless its text gets too long."""
        tiles = self.rows[row]
        return self._with_row(row, (*tiles[:place], address, *tiles[place + 1 :]))

    def moved_sideways(self, row: int, place: int, step: int) -> Layout:
        """Return the layout in which a tile has changed places with its neighbour, if it has one.

        Args:
            row: The row of the tile.
            place: Its place in the row.
            step: 1 is to the right, -1 to the left.
        """
        tiles = list(self.rows[row])
        other = place + step
        if not 0 <= other < len(tiles):
            return self
        tiles[place], tiles[other] = tiles[other], tiles[place]
        return self._with_row(row, tuple(tiles))

    def moved_up(self, row: int, place: int) -> Layout:
        """Return the layout with a tile in the row above, or in a new row at the top."""
        tile = self.rows[row][place]
        rest = self.without(row, place).rows
        if row == 0:
            return self if len(self.rows[0]) == 1 else self._with_rows((tile,), *rest)
        return self._with_rows(*rest[: row - 1], (*rest[row - 1], tile), *rest[row:])

    def moved_down(self, row: int, place: int) -> Layout:
        """Return the layout with a tile in the row below, or in a new row at the bottom."""
        tile = self.rows[row][place]
        is_alone = len(self.rows[row]) == 1
        rest = self.without(row, place).rows
        if row == len(self.rows) - 1:
            return self if is_alone else self._with_rows(*rest, (tile,))
        below = row if is_alone else row + 1
        return self._with_rows(*rest[:below], (*rest[below], tile), *rest[below + 1 :])

    @property
    def is_full(self) -> bool:
        """Whether there is no room for one more tile."""
        return len(self.rows) == _MOST_ROWS and len(self.rows[-1]) > 1

    @property
    def is_allowed(self) -> bool:
        """Whether there are not too many rows, and no row has too many tiles."""
        return len(self.rows) <= _MOST_ROWS and all(len(row) <= _MOST_IN_ROW for row in self.rows)

    def _with_row(self, number: int, row: Row) -> Layout:
        return self._with_rows(*self.rows[:number], row, *self.rows[number + 1 :])

    def _with_rows(self, *rows: Row) -> Layout:
        """Return the layout with other rows. If they are not allowed, return it as it is.

        `read_layout` refuses a text that is too long, so the text must not become so.
        """
        changed = replace(self, rows=tuple(row for row in rows if row))
        is_short = len(changed.text()) <= max(_MOST_CHARACTERS, len(self.text()))
        return changed if changed.is_allowed and is_short else self


def read_layout(text: str, panels: Collection[str]) -> Layout:
    """Return the layout in a JSON text.

    Args:
        text: The text.
        panels: The names of the panels that a layout may contain.

    Raises:
        LayoutError: The text is not a layout.
    """
    try:
        document = read_json_object(text, _MOST_CHARACTERS)
    except JsonError as error:
        raise LayoutError(str(error)) from None
    for key in document.keys() - set(_KEYS):
        hint = did_you_mean(key, _KEYS) or "a layout has `title` and `rows`"
        raise LayoutError(f"a layout has no key {key!r}", hint=hint)
    title = document.get("title", "")
    if not isinstance(title, str) or len(title) > _LONGEST_TITLE:
        raise LayoutError(f"`title` must be a text with at most {_LONGEST_TITLE} characters")
    return Layout(_rows(document.get("rows"), panels), title)


def _rows(rows: Any, panels: Collection[str]) -> tuple[Row, ...]:
    if not isinstance(rows, list) or not all(isinstance(row, list) and row for row in rows):
        raise LayoutError('`rows` must be a list of rows, e.g. [["view", "graph"], ["console"]]')
    if len(rows) > _MOST_ROWS:
        raise LayoutError(f"a layout has at most {_MOST_ROWS} rows, not {len(rows)}")
    return tuple(_row(row, number, panels) for number, row in enumerate(rows, 1))


def _row(row: list[Any], number: int, panels: Collection[str]) -> Row:
    if len(row) > _MOST_IN_ROW:
        raise LayoutError(f"row {number} has {len(row)} panels, and at most {_MOST_IN_ROW} fit")
    if not all(isinstance(tile, str) for tile in row):
        raise LayoutError(f"row {number} must have names of panels, not {json.dumps(row)[:80]}")
    return tuple(checked_tile(tile, panels) for tile in row)


def checked_tile(address: str, panels: Collection[str]) -> str:
    """Return the address of a panel, in which only the necessary characters are escaped.

    Raises:
        LayoutError: There is no such panel.
    """
    name, _, query = address.partition("?")
    if name not in panels:
        hint = did_you_mean(name, panels) or f"there are {', '.join(panels)}"
        raise LayoutError(f"there is no panel {name!r}", hint=hint)
    pairs = urlencode(parse_qsl(query, keep_blank_values=True), safe=_BARE)
    return f"{name}?{pairs}" if pairs else name


def read_layout_file(path: Path, panels: Collection[str]) -> Layout:
    """Return the layout in a file.

    Raises:
        LayoutError: The file cannot be read, or its text is not a layout.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is not UTF-8"
        raise LayoutError(f"cannot read the layout {path}: {reason}") from None
    try:
        return read_layout(text, panels)
    except LayoutError as error:
        raise LayoutError(f"{path}: {error}", hint=error.hint) from None
