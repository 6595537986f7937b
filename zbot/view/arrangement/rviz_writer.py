"""Writer of `.rviz` files. What the view does not have stays as it was in the file."""

from __future__ import annotations

import copy
from itertools import groupby
from typing import TYPE_CHECKING, Any

from zbot.view.arrangement.rviz_displays import RVIZ_DISPLAYS
from zbot.view.arrangement.rviz_file import MANAGER, MARKERS_NAMESPACE, MARKERS_TOPIC
from zbot.view.arrangement.rviz_view import view_properties

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.view.arrangement.arrangement import Arrangement, DisplayChoice, PointerTopics

#: Name of a saved arrangement.
FILE_NAME = "view.rviz"
_PACKAGE = "rviz_default_plugins"
_LEVELS = "Displays"
#: rviz's names of the view's displays that have another one.
_CLASSES = {"Twist": "TwistStamped", "Accel": "AccelStamped", "Text": "Temperature"}
_TOPIC_PATHS = {"RobotModel": "Description Topic"}
_LATCHED = ("RobotModel", "Map")
_TOOLS = ("MoveCamera", "Select", "FocusCamera", "Measure")


def rviz_text(arrangement: Arrangement) -> str:
    """Return the text of an `.rviz` file."""
    import yaml  # noqa: PLC0415 - takes 15 ms

    raw: dict[str, Any] = copy.deepcopy(dict(arrangement.raw)) or _empty(arrangement.topics)
    manager = raw[MANAGER]
    manager[_LEVELS] = _tree(arrangement.displays, 0)
    options = _inner(manager, "Global Options")
    options["Fixed Frame"] = arrangement.fixed_frame or "map"
    if arrangement.background is not None:
        options["Background Color"] = "; ".join(map(str, arrangement.background))
    if arrangement.camera is not None:
        _inner(manager, "Views")["Current"] = view_properties(arrangement.camera)
    # libyaml is ten times faster, but some builds of PyYAML do not have it.
    dumper = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
    return str(yaml.dump(raw, Dumper=dumper, sort_keys=False, allow_unicode=True))


def _inner(raw: dict[str, Any], name: str) -> dict[str, Any]:
    """Return the properties below a name. If there are none, make them."""
    found = raw.get(name)
    made: dict[str, Any] = found if isinstance(found, dict) else {}
    raw[name] = made
    return made


def _empty(topics: PointerTopics) -> dict[str, Any]:
    tools: list[dict[str, Any]] = [
        *({"Class": f"{_PACKAGE}/{name}"} for name in _TOOLS),
        {
            "Class": f"{_PACKAGE}/SetInitialPose",
            "Covariance x": topics.variance_xy,
            "Covariance y": topics.variance_xy,
            "Covariance yaw": topics.variance_yaw,
            "Topic": {"Value": topics.initial_pose},
        },
        {"Class": f"{_PACKAGE}/SetGoal", "Topic": {"Value": topics.goal}},
        {"Class": f"{_PACKAGE}/PublishPoint", "Topic": {"Value": topics.point}},
    ]
    panels = [{"Class": f"rviz_common/{name}", "Name": name} for name in (_LEVELS, "Views")]
    manager = {"Class": "", "Enabled": True, "Name": "root", "Tools": tools, "Value": True}
    return {"Panels": panels, MANAGER: manager}


def _tree(displays: Sequence[DisplayChoice], level: int) -> list[dict[str, Any]]:
    """Return displays, with those of a group inside of it."""
    found = []
    for group, inside in groupby(displays, lambda one: one.groups[level : level + 1]):
        members = list(inside)
        if not group:
            found += [_properties(one) for one in members]
            continue
        found.append(
            {
                "Class": "rviz_common/Group",
                _LEVELS: _tree(members, level + 1),
                "Enabled": any(one.is_on for one in members),
                "Name": group[0],
            }
        )
    return found


def _properties(choice: DisplayChoice) -> dict[str, Any]:
    made = copy.deepcopy(dict(choice.raw))
    made.update(Enabled=choice.is_on, Name=choice.label, Value=choice.is_on)
    if not choice.kind:
        return made
    name = _CLASSES.get(choice.kind, choice.kind)
    made.setdefault("Class", f"{_PACKAGE}/{name}")
    known = RVIZ_DISPLAYS[str(made["Class"]).rpartition("/")[2]]
    written = {
        entry.path: entry.form.write(choice.values[entry.setting])
        for entry in known.entries
        if entry.setting in choice.values
    }
    for path, value in known.split(written).items():
        _put(made, path, value)
    if choice.kind == "InteractiveMarkers" and choice.topic:
        made[MARKERS_NAMESPACE] = choice.topic.removesuffix(MARKERS_TOPIC)
    elif choice.topic and not choice.raw:
        durability = "Transient Local" if choice.kind in _LATCHED else "Volatile"
        made[_TOPIC_PATHS.get(choice.kind, "Topic")] = {
            "Depth": 5,
            "Durability Policy": durability,
            "History Policy": "Keep Last",
            "Reliability Policy": "Reliable",
            "Value": choice.topic,
        }
    return made


def _put(made: dict[str, Any], path: str, value: Any) -> None:
    """Set a property by its path. What is beside it stays."""
    *outer, last = path.split("/")
    for name in outer:
        made = _inner(made, name)
    known = made.get(last)
    if isinstance(value, dict) and isinstance(known, dict):
        made[last] = {**{name: _shown(state, last) for name, state in known.items()}, **value}
    else:
        made[last] = value


def _shown(state: Any, path: str) -> Any:
    """Return the switch of a name that is on now."""
    if isinstance(state, dict) and state.get("Value") is False:
        return {**state, "Value": True}
    return True if path == "Namespaces" else state
