"""Reader of `.rviz` files, in which rviz keeps its displays, its fixed frame and its camera."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.text.yaml_reader import YamlError, read_yaml
from zbot.view.arrangement.arrangement import Arrangement, DisplayChoice, PointerTopics
from zbot.view.arrangement.errors import ArrangementError
from zbot.view.arrangement.property_form import Number, PropertyError, Rgb, is_same
from zbot.view.arrangement.rviz_displays import RVIZ_DISPLAYS, UNNEEDED
from zbot.view.arrangement.rviz_view import camera_of

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from pathlib import Path

    from zbot.view.arrangement.rviz_displays import Properties, RvizDisplay
    from zbot.view.displays.display import Value
    from zbot.view.shape import Color

MANAGER = "Visualization Manager"
_MOST_DISPLAYS = 500
_MOST_LEVELS = 20
#: Values that a short file may have with its aliases. So many characters count as one value more.
_USUAL_SIZE, _CHARACTERS_OF_VALUE = 20_000, 20
_GROUP = "Group"
_OWN = ("rviz", "rviz_default_plugins", "rviz_common", "nav2_rviz_plugins")
_TOPICS = ("Topic", "Image Topic", "Marker Topic", "Description Topic")
#: rviz2 keeps the namespace of interactive markers, and rviz the topic of their updates.
MARKERS_NAMESPACE, MARKERS_TOPIC = "Interactive Markers Namespace", "/update"
_OWN_TOOLS = (
    *("FocusCamera", "GoalTool", "Interact", "Measure", "MoveCamera", "PublishPoint"),
    *("Select", "SetGoal", "SetInitialPose"),
)
_OWN_PANELS = (
    *("Displays", "Help", "Selection", "Time", "Tool Properties", "Views"),
    "Transformation",
)


def read_rviz_file(path: Path) -> Arrangement:
    """Return the arrangement in a file.

    Raises:
        ArrangementError: The file cannot be read, or it is not a file of rviz.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is not a text in UTF-8"
        raise ArrangementError(f"cannot read {path}: {reason}") from error
    try:
        return read_rviz(text)
    except ArrangementError as error:
        raise ArrangementError(f"{path}: {error}") from error


def read_rviz(text: str) -> Arrangement:
    """Return the arrangement in the text of an `.rviz` file.

    Raises:
        ArrangementError: The text is not one of rviz.
    """
    try:
        raw = read_yaml(text)
    except YamlError as error:
        raise ArrangementError(f"it is not YAML: {error}") from error
    manager = raw.get(MANAGER) if isinstance(raw, dict) else None
    if not isinstance(manager, dict):
        raise ArrangementError(f"it is not a file of rviz: it has no '{MANAGER}'")
    _check_size(raw, _USUAL_SIZE + 2 * len(text))
    return _Reading(raw, manager).arrangement()


def _check_size(raw: Any, most: int) -> None:
    """Refuse values that are much larger than their text, because aliases repeat a long part.

    Without aliases, a text has fewer values and characters than the limit.

    Raises:
        ArrangementError: The values are too large.
    """
    waiting, size = [raw], 0
    while waiting:
        value = waiting.pop()
        size += 1 + (len(value) // _CHARACTERS_OF_VALUE if isinstance(value, str) else 0)
        if size > most:
            raise ArrangementError("its aliases repeat too much: write the repeated part shorter")
        if isinstance(value, dict):
            waiting += value.keys()
            waiting += value.values()
        elif isinstance(value, list):
            waiting += value


class _Reading:
    """One reading. It collects what the view does not have."""

    def __init__(self, raw: dict[str, Any], manager: dict[str, Any]) -> None:
        self._raw, self._manager = raw, manager
        self._misfits: dict[str, int] = {}

    def arrangement(self) -> Arrangement:
        options = _mapping(self._manager, "Global Options")
        displays = tuple(self._displays(self._manager.get("Displays"), (), is_on=True))
        topics = self._tools()
        current = _mapping(_mapping(self._manager, "Views"), "Current")
        camera, lacking = camera_of(current, _mapping(self._raw, "Window Geometry"))
        self._lack(lacking)
        for panel in _mappings(self._raw.get("Panels")):
            if _name(panel) not in _OWN_PANELS:
                self._lack(f"panel {_name(panel)}")
        frame = _text(options.get("Fixed Frame")).removeprefix("/")
        return Arrangement(
            displays[:_MOST_DISPLAYS],
            "" if frame.startswith("<") else frame,
            camera,
            _color(options.get("Background Color")),
            topics,
            tuple(f"{what} ({n} times)" if n > 1 else what for what, n in self._misfits.items()),
            self._raw,
        )

    def _lack(self, what: str) -> None:
        if what:
            self._misfits[what] = self._misfits.get(what, 0) + 1

    def _displays(
        self, found: Any, groups: tuple[str, ...], *, is_on: bool
    ) -> Iterator[DisplayChoice]:
        for raw in _mappings(found):
            own_on = is_on and raw.get("Enabled", raw.get("Value", True)) is not False
            if _name(raw) == _GROUP and len(groups) < _MOST_LEVELS:
                inner = (*groups, _text(raw.get("Name")))
                yield from self._displays(raw.get("Displays"), inner, is_on=own_on)
            else:
                yield self._display(raw, groups, is_on=own_on)

    def _display(self, raw: Properties, groups: tuple[str, ...], *, is_on: bool) -> DisplayChoice:
        known = RVIZ_DISPLAYS.get(_name(raw)) if _package(raw) in _OWN else None
        label = _text(raw.get("Name")) or _name(raw)
        if known is None:
            self._lack(f"display {_name(raw)}")
            return DisplayChoice("", label, is_on=is_on, groups=groups, raw=raw)
        file = ""
        if raw.get("Description Source") == "File":
            file = _text(raw.get("Description File"))
        values = self._values(raw, known)
        if known.kind == "Image":
            values["in the scene"] = _name(raw) == "Camera"
        return DisplayChoice(known.kind, label, _topic(raw), is_on, values, file, groups, raw)

    def _values(self, raw: Properties, known: RvizDisplay) -> dict[str, Value]:
        properties = known.combine(flat(raw, {entry.path for entry in known.entries}))
        values: dict[str, Value] = {}
        for entry in known.entries:
            if entry.path in properties:
                try:
                    values[entry.setting] = entry.form.read(properties[entry.path])
                except PropertyError:
                    value = properties[entry.path]
                    shown = "" if isinstance(value, (dict, list)) else f" {value}"[:40]
                    self._lack(f"{_name(raw)}: {entry.path}{shown}")
        for path, value in properties.items():
            is_read = any(path == entry.path for entry in known.entries)
            if not is_read and not _is_unneeded(path, known) and not _is_usual(path, value, known):
                self._lack(f"{_name(raw)}: {path}")
        return values

    def _tools(self) -> PointerTopics:
        found: dict[str, Any] = {}
        for tool in _mappings(self._manager.get("Tools")):
            name, topic = _name(tool), _topic(tool)
            if name == "SetInitialPose":
                found |= {"initial_pose": topic} if topic else {}
                for path, field in (
                    ("Covariance x", "variance_xy"),
                    ("Covariance yaw", "variance_yaw"),
                ):
                    found |= _number(tool.get(path), field)
            elif name in {"SetGoal", "PublishPoint"} and topic:
                found["goal" if name == "SetGoal" else "point"] = topic
            elif name not in _OWN_TOOLS:
                self._lack(f"tool {name}")
        return PointerTopics(**found)


def flat(raw: Properties, whole: set[str], start: str = "") -> Properties:
    """Return properties by path, e.g. `Shape/Color`. Those in `whole` are not divided."""
    found: Properties = {}
    for name, value in raw.items():
        path = f"{start}{name}"
        if isinstance(value, dict) and value and path not in whole and start.count("/") < 5:
            found |= flat(value, whole, f"{path}/")
        else:
            found[path] = value
    return found


def _is_unneeded(path: str, known: RvizDisplay) -> bool:
    parts = path.split("/")
    starts = {"/".join(parts[: number + 1]) for number in range(len(parts))}
    return bool(starts & (UNNEEDED | known.unneeded))


def _is_usual(path: str, value: Any, known: RvizDisplay) -> bool:
    return path in known.usual and is_same(value, known.usual[path])


def _topic(raw: Mapping[str, Any]) -> str:
    if _name(raw) == "InteractiveMarkers":
        namespace = _text(raw.get(MARKERS_NAMESPACE))
        return f"{namespace}{MARKERS_TOPIC}" if namespace else _text(raw.get("Update Topic"))
    for path in _TOPICS:
        value = raw.get(path)
        if isinstance(value, dict):
            value = value.get("Value")
        if isinstance(value, str) and value:
            return value
    return _text(raw.get("Robot Description"))


def _number(raw: Any, field: str) -> dict[str, Any]:
    try:
        Number().read(raw)
        return {field: float(raw)}
    except PropertyError:
        return {}


def _color(raw: Any) -> Color | None:
    try:
        return Rgb().read(raw)
    except PropertyError:
        return None


def _name(raw: Mapping[str, Any]) -> str:
    return _text(raw.get("Class")).rpartition("/")[2]


def _package(raw: Mapping[str, Any]) -> str:
    return _text(raw.get("Class")).rpartition("/")[0]


def _text(value: Any) -> str:
    return value if isinstance(value, str) else ""


def _mapping(raw: Mapping[str, Any], name: str) -> dict[str, Any]:
    found = raw.get(name)
    return found if isinstance(found, dict) else {}


def _mappings(raw: Any) -> Iterator[dict[str, Any]]:
    return (one for one in (raw if isinstance(raw, list) else ()) if isinstance(one, dict))
