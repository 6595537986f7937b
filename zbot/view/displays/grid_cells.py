"""Display GridCells: flat cells, e.g. the obstacles of a planner."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view import solid
from zbot.view.colors import same
from zbot.view.displays.display import Display, Setting
from zbot.view.errors import DisplayError
from zbot.view.points import check_number, positions_of, thinned
from zbot.view.shape import Copies

if TYPE_CHECKING:
    from zbot.view.shape import Shape

_GREEN = (25, 190, 60)
_MOST_CELLS = 20_000
_THICKNESS_M = 0.002


class GridCells(Display):
    """Flat cells at positions."""

    name = "GridCells"
    types = ("nav_msgs/msg/GridCells",)
    settings = (Setting("color", _GREEN),)

    def shapes(self, message: Any) -> list[Shape]:
        """Return the cells of a message."""
        width = check_number(message.cell_width, "cell_width", low=0)
        height = check_number(message.cell_height, "cell_height", low=0)
        if not width or not height:
            raise DisplayError("cell_width and cell_height must be larger than 0")
        cells = message.cells[thinned(len(message.cells), _MOST_CELLS)]
        if len(cells) < len(message.cells):
            self.notice = f"{len(cells)} of {len(message.cells)} cells are shown"
        places = positions_of(cells, "cells")
        if not len(places):
            self.notice = "the message has no cells"
            return []
        sizes = np.tile(np.array([width, height, _THICKNESS_M], np.float32), (len(places), 1))
        vertices, faces = solid.box()
        return [Copies(vertices, faces, places, sizes, same(self.color(), len(places)))]
