"""List of the displays: those of an arrangement, and one for each topic that can be shown."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.libraries.robot_description.file import read_description
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.names import is_hidden
from zbot.view.arrangement.arrangement import DisplayChoice
from zbot.view.displays import DISPLAYS, display_for
from zbot.view.displays.grid import Grid
from zbot.view.displays.laser_scan import LaserScan
from zbot.view.displays.robot_model import RobotModel
from zbot.view.displays.tf import TF
from zbot.view.mesh_file import MeshFiles
from zbot.view.shown import Shown

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from zbot.view.displays.display import Display, Value
    from zbot.view.panel import Panel, Row
    from zbot.view.source import Source

#: Displays that are on from the start, if no arrangement is open.
_USUAL: tuple[type[Display], ...] = (TF, Grid, RobotModel, LaserScan)
#: Topics that are shown from the start, too: the walls and things of a simulated world.
_USUAL_TOPICS = frozenset({"/simulation/things", "/simulation/world"})
#: Displays without a topic that are in the list from the start.
_ALWAYS: tuple[type[Display], ...] = (TF, Grid)
_KINDS = {display.name: display for display in DISPLAYS}
_LABELS = {TF: "Frames", Grid: "Grid"}


class Listed:
    """Display in the list.

    Attributes:
        choice: What an arrangement says about it, or what is usual.
        topic: The full name of its topic. It is empty for a display without a topic.
        label: The name of its display in the scene. No other display in the list has it.
        shown: The display with its messages if it is on, or None.
    """

    def __init__(
        self, kind: type[Display], choice: DisplayChoice, topic: str, label: str, row: Row
    ) -> None:
        self.kind, self.choice, self.topic, self.label, self.row = kind, choice, topic, label, row
        self.values: dict[str, Value] = {
            **{setting.name: setting.value for setting in kind.settings},
            **choice.values,
        }
        self.shown: Shown | None = None

    @property
    def present_choice(self) -> DisplayChoice:
        """What an arrangement would say about it now."""
        is_on = self.shown is not None
        return replace(self.choice, is_on=is_on, values=dict(self.values))


class DisplayList:
    """The list of the displays, and the rows of the panel for it. Only one thread may use it.

    Args:
        system: The domain, or a bag.
        panel: The panel.
        later: Called with a function that the thread of the list must call.
        erase: Called with the label of a display that is off now.
        resolve: Function that returns the full name of a topic in an arrangement.
    """

    def __init__(
        self,
        system: Source,
        panel: Panel,
        later: Callable[[Callable[[], None]], None],
        erase: Callable[[str], None],
        resolve: Callable[[str], str],
    ) -> None:
        self._system, self._panel = system, panel
        self._later, self._erase, self._resolve = later, erase, resolve
        self._files = MeshFiles()
        self._arranged: list[Listed | DisplayChoice] = []
        self._found: dict[str, Listed] = {}
        self._usual = _USUAL
        self._revision = -1
        self._count = 0

    def __iter__(self) -> Iterator[Listed]:
        """Yield all displays, those of the arrangement first."""
        yield from (one for one in self._arranged if isinstance(one, Listed))
        yield from self._found.values()

    def arrange(self, choices: Sequence[DisplayChoice]) -> list[str]:
        """Show the displays of an arrangement, and no other ones.

        Returns:
            What cannot be shown, e.g. a display whose topic is not valid.
        """
        for listed in list(self):
            self._remove(listed)
        self._arranged, self._found, self._usual, self._revision = [], {}, (), -1
        problems = []
        for choice in choices:
            try:
                self._arranged.append(self._arranged_one(choice))
            except ZbotError as error:
                problems.append(f"{choice.label}: {error}")
                self._arranged.append(choice)
        return problems

    def _arranged_one(self, choice: DisplayChoice) -> Listed | DisplayChoice:
        kind = _KINDS.get(choice.kind)
        if kind is None:
            return choice
        topic = choice.topic if kind.has_topic and not choice.file else ""
        full = self._resolve(topic) if topic else ""
        if kind.has_topic and not full and not choice.file:
            return choice  # rviz's displays are without a topic until the user chooses one
        label = choice.label if choice.label not in {"", kind.name} or not full else ""
        text = f"{label}: {full}" if label and full else label or full
        return self._make(kind, choice, full, text)

    def show_file(self, path: Path) -> None:
        """Show a file with a robot description.

        Raises:
            DescriptionError: The file is not a robot description.
        """
        read_description(path)
        choice = DisplayChoice(RobotModel.name, path.name, file=str(path))
        self._arranged.append(self._make(RobotModel, choice, "", path.name))

    def restart(self) -> None:
        """Forget all messages, e.g. because a simulation has begun again."""
        for listed in list(self):
            if listed.shown is not None and listed.topic:
                self._switch(listed, is_on=False)
                self._switch(listed, is_on=True)

    def refresh(self) -> bool:
        """List the topics that can be shown, and forget those that are gone and off.

        Returns:
            Whether the graph has changed since the last call.
        """
        if self._revision == self._system.revision:
            return False
        self._revision = self._system.revision
        arranged = {(one.kind, one.topic) for one in self}
        known: dict[str, tuple[str, type[Display]]] = {
            kind.name: ("", kind) for kind in _ALWAYS if (kind, "") not in arranged
        }
        for name, type_names in self._system.snapshot().topics():
            kind = display_for(name, type_names[0]) if len(type_names) == 1 else None
            if kind is not None and kind.has_topic and not is_hidden(name):
                known[name] = (name, kind)
        for name, (topic, kind) in known.items():
            present = self._found.get(name)
            if present is not None and present.kind is not kind:
                self._remove(present)
            elif present is not None or any((one.kind, one.topic) == (kind, topic) for one in self):
                continue
            self._add(name, topic, kind)
        for name in [name for name in self._found if name not in known]:
            if self._found[name].shown is None:  # what is shown stays
                self._remove(self._found.pop(name))
        return True

    def _add(self, name: str, topic: str, kind: type[Display]) -> None:
        is_on = kind in self._usual or (bool(self._usual) and topic in _USUAL_TOPICS)
        choice = DisplayChoice(kind.name, topic or kind.name, topic, is_on)
        text = topic or _LABELS.get(kind, kind.name)
        self._found[name] = self._make(kind, choice, topic, text)

    def _make(self, kind: type[Display], choice: DisplayChoice, topic: str, text: str) -> Listed:
        def switch(is_on: bool) -> None:
            self._later(lambda: self._switch(listed, is_on=is_on))

        place = 10 + DISPLAYS.index(kind)  # after what is above the list
        row = self._panel.add(kind.name, place, text, is_on=choice.is_on, switch=switch)
        self._count += 1
        label = f"{kind.name} {choice.label} {self._count}"
        listed = Listed(kind, choice, topic, label, row)
        self._switch(listed, is_on=choice.is_on)
        return listed

    def _remove(self, listed: Listed) -> None:
        self._switch(listed, is_on=False)
        listed.row.remove()
        if all(other.kind is not listed.kind for other in self if other is not listed):
            self._panel.drop(listed.kind.name)

    def _switch(self, listed: Listed, *, is_on: bool) -> None:
        if is_on == (listed.shown is not None):
            return
        if listed.shown is not None:
            listed.shown.release()
            listed.shown = None
            listed.row.close()
            self._erase(listed.label)
            return
        display = listed.kind(listed.topic, self._files)
        display.values.update(listed.values)
        names = [listed.topic, *display.more_topics] if listed.topic else []
        watches = [self._system.watch(name, keep=display.kept) for name in names]
        shown = listed.shown = Shown(display, watches)
        self._show_file(listed)

        def change(name: str, value: Value) -> None:
            self._later(lambda: self._change(listed, shown, name, value))

        listed.row.open(display, change)

    def _change(self, listed: Listed, shown: Shown, name: str, value: Value) -> None:
        listed.values[name] = value
        shown.change(name, value)
        self._show_file(listed)

    @staticmethod
    def _show_file(listed: Listed) -> None:
        """Show the file with the robot description, if the display has one."""
        if not listed.choice.file or listed.shown is None:
            return
        try:
            listed.shown.show(String(data=read_description(Path(listed.choice.file))))
        except DescriptionError as error:
            listed.shown.mistake = str(error)

    def choices(self) -> tuple[DisplayChoice, ...]:
        """Return the displays as an arrangement has them: all of its own, and what is on."""
        arranged = (
            one.present_choice if isinstance(one, Listed) else one for one in self._arranged
        )
        found = (one.present_choice for one in self._found.values() if one.shown is not None)
        return (*arranged, *found)
