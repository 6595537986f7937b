"""Base class of displays. A display makes shapes from the messages of one topic."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from zbot.view.errors import DisplayError
from zbot.view.mesh_file import MeshFiles
from zbot.view.shape import Color, Item

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.tf2.rigid import Vector
    from zbot.view.shape import Shape

Value = bool | float | str | Color


@dataclass(frozen=True)
class Setting:
    """Setting of a display: a switch, a number, a choice of words, a text or a colour.

    The limits of a number are those of its slider. A file may have a number outside of them.
    """

    name: str
    value: Value  #: the first value
    choices: tuple[str, ...] = ()
    low: float = 0.0
    high: float = 1.0
    step: float = 0.01


class Outgoing(NamedTuple):
    """Message that a display sends. Without a message, the publisher is made ready."""

    topic: str
    type_name: str
    message: Any = None


class Call(NamedTuple):
    """Call of a service. `take` gets the response."""

    service: str
    type_name: str
    request: Any


class Display:
    """Display of one topic. Only one thread may call its methods.

    Args:
        topic: The full name of the topic.
        files: The files of surfaces that messages name.

    Attributes:
        name: The name of the display in rviz.
        types: The full names of the types of messages that it can show.
        settings: Its settings, with their first values.
        has_topic: Whether it shows the messages of a topic.
        kept: The number of messages that are kept between two calls of `take`. It is 0 for a
            display that shows only the newest message.
        stays: Whether an item stays where it is in the fixed frame, once its place is known.
        items: The present shapes by name.
        notice: A sentence about the last message, e.g. that points were left out.
        outgoing: Messages that the view must send.
        calls: Calls that the view must make.
        menus: The entries of each menu that the user may open.
    """

    name: ClassVar[str]
    types: ClassVar[tuple[str, ...]]
    settings: ClassVar[tuple[Setting, ...]] = ()
    has_topic: ClassVar[bool] = True
    kept: ClassVar[int] = 0
    stays: ClassVar[bool] = False

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        self.topic = topic
        self.files = MeshFiles() if files is None else files
        self.values: dict[str, Value] = {setting.name: setting.value for setting in self.settings}
        self.items: dict[str, Item] = {}
        self.notice = ""
        self.outgoing: list[Outgoing] = []
        self.calls: list[Call] = []
        self.menus: Mapping[str, tuple[str, ...]] = {}

    @property
    def more_topics(self) -> Sequence[str]:
        """Further topics whose messages `take` gets, e.g. the updates of a map."""
        return ()

    def take(self, message: Any) -> None:
        """Show a message.

        Raises:
            DisplayError: The message cannot be drawn.
        """
        self.notice = ""
        self.items = {"": item(message.header, self.shapes(message))}

    def shapes(self, message: Any) -> list[Shape]:
        """Return the shapes of a message, in the frame of its header.

        Raises:
            DisplayError: The message cannot be drawn.
        """
        raise NotImplementedError

    def tick(self, now_ns: int) -> None:
        """Change shapes that depend on the time. The times are in nanoseconds since the epoch."""

    def change(self, name: str, value: Value) -> None:
        """Change a setting. The view then gives the newest message to `take` again.

        A display that keeps messages (`kept`) draws its shapes again itself, if necessary.
        """
        self.values[name] = value

    def press(self, name: str, place: Vector) -> str:  # noqa: ARG002 - a class may need them
        """Click an item at a place in its frame. Return a sentence, or "" if it is no button."""
        return ""

    def choose(self, menu: str, entry: str) -> None:
        """Choose an entry of a menu."""

    def number(self, name: str) -> float:
        """Return the value of a setting that is a number."""
        value = self.values[name]
        return 0.0 if isinstance(value, tuple) else float(value)

    def color(self, name: str = "color") -> Color:
        """Return the value of a setting that is a colour."""
        value = self.values[name]
        return value if isinstance(value, tuple) else (0, 0, 0)

    def words(self, name: str) -> frozenset[str]:
        """Return the words of a setting that is a text. Commas and spaces separate them."""
        return frozenset(str(self.values[name]).replace(",", " ").split())


def item(header: Any, shapes: Sequence[Shape]) -> Item:
    """Return shapes in the frame of a `std_msgs/Header`.

    Raises:
        DisplayError: The header names no frame.
    """
    frame = header.frame_id.removeprefix("/")
    if not frame:
        raise DisplayError("the message names no frame: its publisher must set header.frame_id")
    return Item(frame, header.stamp.sec * 10**9 + header.stamp.nanosec, tuple(shapes))
