"""Display Map: an occupancy grid, with the colours of a map or of a costmap."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.tf2.rigid import Rigid
from zbot.view.displays.display import Display, Setting, item
from zbot.view.errors import DisplayError
from zbot.view.points import check_number
from zbot.view.pose import pose_of
from zbot.view.shape import Plane

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from zbot.view.displays.display import Value
    from zbot.view.mesh_file import MeshFiles
    from zbot.view.shape import Shape

_MOST_CELLS = 100_000_000
_MOST_SIDE = 2048  #: cells of the picture: larger maps are thinned
_UPDATE_TYPE = "OccupancyGridUpdate"


class Map(Display):
    """Occupancy grid with its updates, drawn just below the plane of the grid."""

    name = "Map"
    types = ("nav_msgs/msg/OccupancyGrid",)
    settings = (
        Setting("color", "map", ("map", "costmap")),
        Setting("opacity", 1.0, low=0.1, high=1.0, step=0.1),
    )
    kept = 20

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        if "costmap" in topic:
            self.values["color"] = "costmap"
        self._grid: Any = None
        self._cells: NDArray[np.int8] | None = None

    @property
    def more_topics(self) -> Sequence[str]:
        """The topic of the updates."""
        return (f"{self.topic}_updates",)

    def take(self, message: Any) -> None:
        """Show a whole map, or change a rectangle of it."""
        self.notice = ""
        if type(message).__name__ == _UPDATE_TYPE:
            self._update(message)
        else:
            self._cells = _cells(message, message.info.width, message.info.height).copy()
            self._grid = message
        self.items = {"": item(self._grid.header, self.shapes(self._grid))}

    def change(self, name: str, value: Value) -> None:
        """Change the colours, also of a map that is not published again."""
        super().change(name, value)
        if self._grid is not None:
            self.items = {"": item(self._grid.header, self.shapes(self._grid))}

    def _update(self, update: Any) -> None:
        if self._cells is None:
            raise DisplayError("an update came before the first whole map")
        rows, columns = self._cells.shape
        inside = 0 <= update.x <= columns - update.width and 0 <= update.y <= rows - update.height
        if not inside:
            raise DisplayError(
                f"an update of {update.width}x{update.height} cells at {update.x}, {update.y} "
                f"does not fit into the map of {columns}x{rows}"
            )
        part = _cells(update, update.width, update.height)
        self._cells[update.y : update.y + update.height, update.x : update.x + update.width] = part

    def shapes(self, message: Any) -> list[Shape]:
        """Return the picture of a grid."""
        info = message.info
        cells = self._cells
        if cells is None:
            cells = _cells(message, info.width, info.height)
        cell_m = check_number(info.resolution, "info.resolution", low=0)
        if not cell_m:
            raise DisplayError("info.resolution is 0: it must be the size of a cell in metres")
        width, height = info.width * cell_m, info.height * cell_m
        step = -(-max(cells.shape) // _MOST_SIDE)
        if step > 1:
            self.notice = f"the map is large: every {step}th cell is drawn"
        palette = _COSTMAP if self.values["color"] == "costmap" else _MAP
        # The first cell of a map is at its origin, the first row of a picture is at the top.
        pixels = palette[cells[::step, ::step].view(np.uint8)][::-1]
        if self.number("opacity") < 1:
            alpha = np.full((*pixels.shape[:2], 1), 255 * self.number("opacity"), np.uint8)
            pixels = np.concatenate([pixels, alpha], axis=2)
        centre = pose_of(info.origin) @ Rigid((width / 2, height / 2, -0.01))
        return [Plane(pixels, width, height, centre)]


def _cells(message: Any, width: int, height: int) -> NDArray[np.int8]:
    if not width or not height:
        raise DisplayError(f"the map is empty: it has {width}x{height} cells")
    if width * height > _MOST_CELLS:
        raise DisplayError(f"the map has {width}x{height} cells: the limit is {_MOST_CELLS}")
    if len(message.data) != width * height:
        raise DisplayError(
            f"the map has {len(message.data)} values for {width}x{height} = {width * height} cells"
        )
    return np.asarray(message.data, np.int8).reshape(height, width)


def _map_palette() -> NDArray[np.uint8]:
    """Return a map's colours: white is free, black is occupied, unknown is a grey green."""
    colors = np.zeros((256, 3), np.uint8)
    colors[:101] = np.linspace(255, 0, 101).round()[:, None]
    colors[101:128] = (0, 255, 0)  # not valid, as in rviz
    colors[128:] = (255, 120, 0)  # not valid either
    colors[255] = (112, 137, 134)
    return colors


def _costmap_palette() -> NDArray[np.uint8]:
    """Return a costmap's colours: from blue to red, cyan at a wall, magenta inside of it."""
    colors = _map_palette()
    share = np.linspace(0, 1, 98)
    colors[1:99] = np.stack([255 * share, 0 * share, 255 * (1 - share)], axis=1).round()
    colors[0] = (240, 240, 240)
    colors[99], colors[100] = (0, 255, 255), (255, 0, 255)
    return colors


_MAP = _map_palette()
_COSTMAP = _costmap_palette()
