"""Pointer: the tool that the user has chosen, and what a click does."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from zbot.errors import ZbotError
from zbot.observer.value_text import tree
from zbot.view.tools.pick import distance
from zbot.view.tools.ray import floor_point
from zbot.view.tools.tool import TOOLS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any

    from zbot.tf2.rigid import Rigid, Vector
    from zbot.view.shape import Item
    from zbot.view.tools.ray import Ray
    from zbot.view.tools.tool import Surroundings, Tool

MOVE_CAMERA, INTERACT, SELECT = "Move Camera", "Interact", "Select"
#: The names of all tools, in the order of the list.
TOOL_NAMES = (MOVE_CAMERA, INTERACT, SELECT, *(tool.name for tool in TOOLS))
_BY_NAME = {tool.name: tool for tool in TOOLS}
_MOST_ROWS = 40
_LONGEST = 80
_NO_FLOOR = "The click does not meet the floor (z = 0 of the fixed frame)."


class Drawn(NamedTuple):
    """Item in the scene."""

    display: str  #: the name of its display
    topic: str  #: empty if it has none
    name: str  #: its name in its display
    item: Item
    pose: Rigid  #: of its shapes in the fixed frame
    message: Any  #: the last message of its display, or None
    press: Callable[[Vector], str] | None = None  #: called with the place in the item's frame


class Pointer:
    """The tool that the user has chosen. Only one thread may use it.

    Args:
        surroundings: Function that returns what a tool needs.
        drawn: Function that returns all items in the scene.
        frames: Function that returns the pose of each frame in the fixed frame.

    Attributes:
        sentence: What to do, or what has happened.
    """

    def __init__(
        self,
        surroundings: Callable[[], Surroundings],
        drawn: Callable[[], Iterable[Drawn]],
        frames: Callable[[], Mapping[str, Rigid]],
    ) -> None:
        self._surroundings, self._drawn, self._frames = surroundings, drawn, frames
        self._name = MOVE_CAMERA
        self._tool: Tool | None = None
        self.sentence = ""

    @property
    def items(self) -> Mapping[str, Item]:
        """What the tool shows in the scene."""
        return {} if self._tool is None else self._tool.items

    def choose(self, name: str) -> None:
        """Choose a tool by its name."""
        self._name, self._tool, self.sentence = name, None, ""
        if name == SELECT:
            self.sentence = "Click an object."
        elif name == INTERACT:
            self.sentence = "Click an interactive marker."
        elif name in _BY_NAME:
            self._tool = _BY_NAME[name]()
            self.sentence = self._tool.hint
            try:
                self._tool.begin(self._surroundings())
            except ZbotError as error:
                self._tool, self.sentence = None, str(error)

    def click(self, ray: Ray) -> None:
        """Use the tool where a ray in the fixed frame meets the floor or an object."""
        if self._name == SELECT:
            self.sentence = self._selected(ray)
        elif self._name == INTERACT:
            self.sentence = self._pressed(ray)
        elif self._tool is not None:
            place = floor_point(ray)
            self.sentence = _NO_FLOOR if place is None else self._use(self._tool, place)

    def _use(self, tool: Tool, place: Vector) -> str:
        around = self._surroundings()
        if not around.fixed_frame:
            return "There is no fixed frame yet: nobody publishes a frame."
        try:
            return tool.click(place, around)
        except ZbotError as error:
            return str(error)

    def _selected(self, ray: Ray) -> str:
        """Return a text about the nearest object that a ray meets."""
        best, place = _nearest(ray, self._drawn())
        if best is None:
            return "There is no object. Click an object."
        return self._description(best, place)

    def _pressed(self, ray: Ray) -> str:
        """Press the nearest object that a ray meets."""
        best, place = _nearest(ray, self._drawn())
        pressed = ""
        if best is not None and best.press is not None:
            in_frame = (best.pose @ best.item.pose.inverse()).inverse().apply(place)
            pressed = best.press(in_frame)
        return pressed or "There is no interactive marker. Click one."

    def _description(self, drawn: Drawn, place: Vector) -> str:
        frame = drawn.item.frame or self._nearest_frame(place)
        lines = [
            f"{drawn.display} {drawn.topic}".strip(),
            f"frame: {frame}",
            f"place: {', '.join(f'{part:.2f}' for part in place)}",
        ]
        if drawn.name and drawn.display != "TF":
            lines.insert(1, f"part: {drawn.name}")
        if drawn.message is not None:
            rows = tree(drawn.message)[:_MOST_ROWS]
            lines += [f"{'  ' * row.depth}{row.name}: {row.text[:_LONGEST]}" for row in rows]
        return "\n".join(lines)

    def _nearest_frame(self, place: Vector) -> str:
        def far(name: str) -> float:
            there = frames[name].translation
            return sum((a - b) ** 2 for a, b in zip(place, there, strict=True))

        frames = self._frames()
        return min(frames, key=far, default="")


def _nearest(ray: Ray, drawn: Iterable[Drawn]) -> tuple[Drawn | None, Vector]:
    """Return the nearest object that a ray meets, or None, and the place."""
    best, nearest = None, math.inf
    for one in drawn:
        far = distance(ray.seen_from(one.pose), one.item)
        if far is not None and far < nearest:
            best, nearest = one, far
    return best, ray.at(nearest if best is not None else 0.0)
