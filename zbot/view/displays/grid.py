"""Displays Grid and Axes, which are at a frame and have no topic."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from zbot.tf2.rigid import Rigid
from zbot.view.colors import same
from zbot.view.displays.display import Display, Setting
from zbot.view.shape import Axes as AxesShape
from zbot.view.shape import Item, Lines

if TYPE_CHECKING:
    from zbot.view.displays.display import Value
    from zbot.view.mesh_file import MeshFiles
    from zbot.view.shape import Shape

_GREY = (160, 160, 164)
_FRAME = Setting("frame", "")
_MOST_CELLS = 500
#: The axes of the lines in each plane.
_PLANES = {"XY": (0, 1), "XZ": (0, 2), "YZ": (1, 2)}


class AtFrame(Display):
    """Shapes at a frame that no message names. An empty name means the fixed frame."""

    types = ()
    has_topic = False

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._shown: dict[str, Value] = {}

    def tick(self, now_ns: int) -> None:  # noqa: ARG002 - the base class has it
        """Make the shapes again after a change of a setting."""
        if self._shown != self.values:
            self._shown = dict(self.values)
            frame = str(self.values["frame"]).removeprefix("/")
            self.items = {"": Item(frame, 0, tuple(self.lasting_shapes()))}

    def lasting_shapes(self) -> list[Shape]:
        """Return the shapes in the frame."""
        raise NotImplementedError


class Grid(AtFrame):
    """Lines of a square grid around the origin of a frame."""

    name = "Grid"
    settings = (
        Setting("cell size", 1.0, low=0.1, high=10.0, step=0.1),
        Setting("cells", 20.0, low=1, high=100, step=1),
        Setting("plane", "XY", tuple(_PLANES)),
        Setting("height", 0.0, low=-10, high=10, step=0.1),
        Setting("color", _GREY),
        _FRAME,
    )

    def lasting_shapes(self) -> list[Shape]:
        """Return the lines."""
        cells = int(min(max(self.number("cells"), 1), _MOST_CELLS))
        half = cells * self.number("cell size") / 2
        places = np.linspace(-half, half, cells + 1)
        ends = np.zeros((2, cells + 1, 2, 3), np.float32)
        first, second = _PLANES[str(self.values["plane"])]
        (third,) = {0, 1, 2} - {first, second}
        for lines, (along, across) in zip(ends, ((first, second), (second, first)), strict=True):
            lines[:, 0, along], lines[:, 1, along] = -half, half
            lines[:, :, across] = places[:, None]
        ends[..., third] = self.number("height")
        return [Lines(ends.reshape(-1, 2, 3), same(self.color(), 2 * cells + 2, 2), 1.0)]


class Axes(AtFrame):
    """Axes at a frame: x is red, y is green and z is blue."""

    name = "Axes"
    settings = (Setting("length", 1.0, low=0.05, high=5.0, step=0.05), _FRAME)

    def lasting_shapes(self) -> list[Shape]:
        """Return the axes."""
        return [AxesShape((Rigid(),), self.number("length"))]
