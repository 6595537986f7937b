"""Display that is on, with the messages of its topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.view.budget import MOVE_BYTES, size_of
from zbot.view.displays.tf import TF
from zbot.view.errors import DisplayError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.watch import Watch
    from zbot.tf2.rigid import Rigid
    from zbot.view.displays.display import Display, Value
    from zbot.view.frames import Frames
    from zbot.view.shape import Item


class Shown:
    """Display that is on, with the messages of its topic.

    Attributes:
        display: The display.
        mistake: What is wrong with the last message.
        lacking: An item without a right pose.
        warning: Why it has none.
        message: The last message, or None.
    """

    def __init__(self, display: Display, watches: list[Watch]) -> None:
        self.display = display
        self.mistake = ""
        self.lacking: Item | None = None
        self.warning = ""
        self.message: Any = None
        self._watches = watches
        self._seen = [0 for _ in watches]
        self._fitting: dict[str, tuple[Item, Item]] = {}  # what is drawn of each item
        self._placed: dict[str, tuple[Item, str, Rigid]] = {}  # items that stay, in a fixed frame

    def take(self) -> str:
        """Give new messages to the display. Return the frame of one of its items."""
        display = self.display
        for place, watch in enumerate(self._watches):
            newest = watch.newest
            if newest is None or newest.number == self._seen[place]:
                continue
            records = watch.since(self._seen[place]) if display.kept else [newest]
            self._seen[place] = newest.number
            if place == 0 and watch.type_name not in display.types:
                self.mistake = f"this display does not show messages of {watch.type_name}"
                continue
            for record in records:
                message = watch.read(record)
                if message is not None:
                    self.show(message)
        return next((item.frame for item in display.items.values() if item.frame), "")

    def skip(self) -> None:
        """Drop the messages that have come since the last call of `take`."""
        for place, watch in enumerate(self._watches):
            if watch.newest is not None:
                self._seen[place] = watch.newest.number

    def show(self, message: Any) -> None:
        """Give a message to the display. Keep what is wrong with it."""
        self.message = message
        try:
            self.display.take(message)
            self.mistake = ""
        except DisplayError as error:
            self.mistake = str(error)
        except Exception as error:  # noqa: BLE001 - a message of another program must not stop all
            self.mistake = f"the message cannot be drawn: {type(error).__name__}: {error}"

    def change(self, name: str, value: Value) -> None:
        """Change a setting, and draw the newest message again."""
        self.display.change(name, value)
        if not self.display.kept:
            self._seen = [0 for _ in self._seen]

    def fitting(self, name: str, item: Item, make: Callable[[Item], Item]) -> Item:
        """Return what is drawn of an item. As long as the item stays, it is the same object."""
        known = self._fitting.get(name)
        if known is None or known[0] is not item:
            known = self._fitting[name] = (item, make(item))
            gone = self._fitting.keys() - self.display.items.keys()
            for other in gone:
                del self._fitting[other]
        return known[1]

    def pose(self, name: str, item: Item, frames: Frames) -> tuple[Rigid | None, bool]:
        """Return the pose of an item's frame in the fixed frame, and whether it is right."""
        if not self.display.stays:
            return frames.pose(item.frame, item.stamp_ns)
        known = self._placed.get(name)
        if known is not None and known[0] is item and known[1] == frames.fixed:
            return known[2], True
        exact = frames.exact_pose(item.frame, item.stamp_ns)
        if exact is None:
            return frames.pose(item.frame, item.stamp_ns)
        self._placed[name] = (item, frames.fixed, exact)
        for other in self._placed.keys() - self.display.items.keys():
            del self._placed[other]
        return exact, True

    def demand(self, most_hz: float) -> float:
        """Return about how many bytes a second the display would send without a budget."""
        items = self.display.items.values()
        rate_hz = min(self._watches[0].rate_hz, most_hz) if self._watches else 0.0
        changed = rate_hz * sum(size_of(item) for item in items)
        if isinstance(self.display, TF):
            changed = most_hz * sum(size_of(item) for item in items if not item.frame)
        return changed + most_hz * MOVE_BYTES * len(items)

    def sentence(self) -> tuple[str, bool]:
        """Return what the display lacks and True, or its state and False."""
        watch = self._watches[0] if self._watches else None
        if watch is not None and watch.problem:
            return watch.problem, True
        if watch is not None and not watch.count and not self.display.items:
            return f"no message on {watch.topic} yet", True
        for warning in (self.mistake, self.warning, self.display.notice):
            if warning:
                return warning, True
        if watch is None or not watch.rate_hz:
            return "", False
        return f"{watch.rate_hz:.1f} messages a second", False

    def release(self) -> None:
        """End the subscriptions."""
        for watch in self._watches:
            watch.release()
