"""Budget of a view: how much it sends to each browser, shared fairly by its displays."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from zbot.view.points import thinned
from zbot.view.shape import Arrows, Axes, Copies, Frustum, Lines, Mesh, Picture, Plane, Points

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.view.shape import Item

#: Bytes of a message that moves an item, after compression.
MOVE_BYTES = 25
_POINT_BYTES = 9  #: three numbers of 2 bytes, and a colour
_PLAIN_SHARE = 0.9  #: the rest is for the panel
#: A cloud is thinned until it can be drawn this many times a second.
_LEAST_HZ = 3.0
_CREDIT_S = 0.1
_FEWEST_POINTS = 100
_PNG_SHARE = 0.1  #: of the bytes of a map's picture
_SMALL_BYTES = 200
_ARRAYS = ("positions", "colors", "ends", "vertices", "faces", "scales")


class Budget:
    """Budget for what displays send. Only one thread may use it.

    Args:
        bytes_per_s: The bytes a second for each browser, or None for no limit.
    """

    def __init__(self, bytes_per_s: float | None) -> None:
        self.total = None if bytes_per_s is None else bytes_per_s * _PLAIN_SHARE
        self._shares: dict[str, float] = {}
        self._due_s: dict[str, float] = {}

    def plan(self, demands: Mapping[str, float]) -> None:
        """Share the budget.

        Args:
            demands: The bytes a second that each display would send without a budget.
        """
        if self.total is not None:
            self._shares = fair_shares(self.total, demands)
            self._due_s = {name: due_s for name, due_s in self._due_s.items() if name in demands}

    def is_due(self, display: str, now_s: float) -> bool:
        """Return whether a display may be drawn now."""
        return self.total is None or now_s >= self._due_s.get(display, 0.0)

    def spend(self, display: str, size: float, now_s: float) -> None:
        """Note that a display has sent some bytes. It is due again when its share allows more."""
        if self.total is not None and size:
            # Drawings come at fixed times. What one of them is late is made up for by the next.
            start_s = max(self._due_s.get(display, 0.0), now_s - _CREDIT_S)
            self._due_s[display] = start_s + size / max(self._share(display), 1.0)

    def fitting(self, display: str, item: Item) -> Item:
        """Return an item with so few points that its display can be drawn three times a second."""
        if self.total is None:
            return item
        most = max(int(self._share(display) / _LEAST_HZ / _POINT_BYTES), _FEWEST_POINTS)
        if all(not isinstance(one, Points) or len(one.positions) <= most for one in item.shapes):
            return item
        return item._replace(shapes=tuple(_fewer(shape, most) for shape in item.shapes))

    def _share(self, display: str) -> float:
        return self._shares.get(display, (self.total or 0.0) / (len(self._shares) + 1))


def _fewer(shape: Any, most: int) -> Any:
    if not isinstance(shape, Points):
        return shape
    kept = thinned(len(shape.positions), most)
    return replace(shape, positions=shape.positions[kept], colors=shape.colors[kept])


def fair_shares(total: float, demands: Mapping[str, float]) -> dict[str, float]:
    """Return the share of each demand. What a small demand leaves is for the larger ones.

    If all demands fit, the rest is shared too.
    """
    shares: dict[str, float] = {}
    left = total
    for place, name in enumerate(sorted(demands, key=lambda name: demands[name])):
        equal = left / (len(demands) - place)
        shares[name] = min(demands[name], equal)
        left -= shares[name]
    rest = left / len(demands) if demands else 0.0
    return {name: share + rest for name, share in shares.items()}


def size_of(item: Item) -> float:
    """Return about how many bytes an item has when it is sent."""
    return sum(_size(shape) for shape in item.shapes)


def _size(shape: Any) -> float:
    if isinstance(shape, Points):
        return float(len(shape.positions) * _POINT_BYTES)
    if isinstance(shape, Plane):
        return shape.pixels.nbytes * _PNG_SHARE
    if isinstance(shape, (Picture, Frustum)):
        picture = shape.picture if isinstance(shape, Frustum) else shape
        return len(picture.data) * 4 / 3
    if isinstance(shape, Axes):
        return 28.0 * len(shape.poses)
    if isinstance(shape, (Lines, Arrows, Mesh, Copies)):
        arrays = (getattr(shape, name, None) for name in _ARRAYS)
        return float(sum(array.nbytes for array in arrays if array is not None))
    return _SMALL_BYTES
