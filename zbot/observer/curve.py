"""Curves of a plot, which show numeric fields of topics over time."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Protocol

from zbot.interfaces.field_path import FieldPath, FieldPathError
from zbot.observer.errors import ViewerError
from zbot.observer.value_text import tree
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.observer.watch import Watch

#: Number of messages that are kept while the page is in the background, e.g. 20 s of a topic with
#: 1000 Hz.
KEPT_MESSAGES = 20_000
#: The largest number of curves for a topic, if the user gives no field.
_MOST_FIELDS = 8
#: Longest time for one `take`: a page that waits stops all pages.
_TAKE_S = 0.01
Branch = dict[str, Any]


class Watcher(Protocol):
    """Object with a method `watch`: a page, or the system."""

    def watch(self, topic: str, *, keep: int) -> Watch:
        """Watch a topic."""
        raise NotImplementedError


def curve_error(word: str, reason: str) -> ViewerError:
    """Return the error that a text is not the name of a curve."""
    hint = "write a topic and one of its numeric fields: /turtle1/pose.x"
    return ViewerError(f"{word!r} is not a curve: {reason}", hint=hint)


def split_curve(word: str, topics: Iterable[str]) -> tuple[str, str]:
    """Return the topic and the field of a curve. The field is empty if the text has no field.

    Args:
        word: `/turtle1/pose.x`, or `/turtle1/pose/x` as in rqt_plot. The first slash is optional.
        topics: The present topics. They show which part of `/turtle1/pose/x` is the topic.

    Raises:
        ViewerError: The topic is missing.
        FieldPathError: The field is not a valid path.
    """
    name, _, field = word.strip().partition(".")
    name = "/" + name.strip("/")
    if name == "/":
        raise curve_error(word, "the topic is missing")
    if field:
        FieldPath(field)  # raises an error with the reason
        return name, field
    known = [topic for topic in topics if name.startswith(f"{topic}/")]
    if known and name not in topics:
        topic = max(known, key=len)
        return topic, name[len(topic) + 1 :].replace("/", ".")
    return name, ""


def numeric_fields(message: Any) -> list[str]:
    """Return the paths of a message's numbers, e.g. `linear.x` and `ranges[0]`."""
    return [row.path for row in tree(message) if row.is_number]


def thinned(
    times: Sequence[float], values: Sequence[float], count: int
) -> list[tuple[float, float]]:
    """Return at most `count` points of a curve. A curve through these points looks the same.

    The curve is cut into parts. The lowest and the highest point of each part are returned.
    """
    size = max(-(-2 * len(times) // max(count, 2)), 1)
    points = []
    for start in range(0, len(times), size):
        part = range(start, min(start + size, len(times)))
        low = min(part, key=values.__getitem__)
        high = max(part, key=values.__getitem__)
        points += [(times[index], values[index]) for index in sorted({low, high})]
    return points


def value_at(message: Any, path: FieldPath) -> float:
    """Return a number of a message. Booleans are 0 and 1.

    Raises:
        FieldPathError: The field is missing or not a number.
    """
    value = path.select(message)
    try:
        return float(value)
    except (TypeError, ValueError):
        reason = f"it is not a number but {type(value).__name__}"
        raise FieldPathError(path.text, reason) from None


class Curve:
    """Curve that shows one field over time.

    Attributes:
        topic: The full name of the topic.
        field: The field's path.
        problem: The reason why the last message gave no point, or an empty text if it gave one.
        last: The newest value, or None before the first value.
    """

    def __init__(self, topic: str, field: str) -> None:
        self.topic, self.field = topic, field
        self.path = FieldPath(field)
        self.problem = ""
        self.last: float | None = None

    @property
    def name(self) -> str:
        """The name of the curve, with a dot before the field: `/turtle1/pose.x`."""
        return f"{self.topic}.{self.field}"

    def value(self, message: Any) -> float | None:
        """Return the field's value in a message.

        If the message has no such number, set `problem` and return None.
        """
        try:
            self.last = value_at(message, self.path)
        except FieldPathError as error:
            self.problem = str(error)
            return None
        self.problem = ""
        return self.last


class _Topic:
    """Watched topic, with the number of the last message that was read for its curves."""

    def __init__(self, watch: Watch) -> None:
        self.watch = watch
        self.read_count = watch.count


Points = dict[str, list[float]]


class Curves:
    """Curves of one plot. `take` returns the points that came after the previous `take`.

    Args:
        watcher: The object that watches the topics of the curves.
    """

    def __init__(self, watcher: Watcher) -> None:
        self._watcher = watcher
        self._topics: dict[str, _Topic] = {}
        self._wholes: list[str] = []
        self._curves: dict[str, Curve] = {}

    @property
    def curves(self) -> Sequence[Curve]:
        """The curves, in the order in which they were added."""
        return list(self._curves.values())

    @property
    def waiting(self) -> list[str]:
        """The topics that were added without a field, until their first message is read."""
        return list(self._wholes)

    def add(self, topic: str, field: str) -> None:
        """Add a curve. If the field is empty, add curves for the numbers of the first message.

        Raises:
            FieldPathError: The field is not a valid path.
        """
        if field:
            curve = Curve(topic, field)
            self._curves.setdefault(curve.name, curve)
        elif topic not in self._wholes:
            self._wholes.append(topic)
        if topic not in self._topics:
            self._topics[topic] = _Topic(self._watcher.watch(topic, keep=KEPT_MESSAGES))

    def remove(self, name: str) -> None:
        """Remove a curve, or a topic that was added without a field. Ignore an unknown name."""
        self._curves.pop(name, None)
        if name in self._wholes:
            self._wholes.remove(name)
        used = {curve.topic for curve in self.curves} | set(self._wholes)
        for topic in self._topics.keys() - used:
            self._topics.pop(topic).watch.release()

    def problem(self, curve: Curve) -> str:
        """Return the reason why a curve gets no points, or an empty text if it gets points."""
        watch = self._topics[curve.topic].watch
        if watch.type_name is None:
            return f"no node uses {curve.topic} yet"
        return watch.problem or curve.problem

    def take(self) -> Points:
        """Return each curve's new points: [time in s since the epoch, value, time, value, ...].

        If there are many new messages, the next calls return the rest.
        """
        found: Points = {}
        deadline = Deadline(_TAKE_S)
        for name, topic in self._topics.items():
            for record, message in topic.watch.read_since(topic.read_count, deadline):
                topic.read_count = record.number
                if message is None:
                    continue
                if name in self._wholes:
                    self._resolve(name, message)
                self._read(name, message, record.time_ns / 1e9, found)
        return found

    def _resolve(self, topic: str, message: Any) -> None:
        self._wholes.remove(topic)
        for field in numeric_fields(message)[:_MOST_FIELDS]:
            curve = Curve(topic, field)
            self._curves.setdefault(curve.name, curve)

    def _read(self, topic: str, message: Any, time_s: float, found: Points) -> None:
        for curve in self._curves.values():
            if curve.topic == topic:
                value = curve.value(message)
                if value is not None:
                    found.setdefault(curve.name, []).extend((time_s, value))


def curve_tree(fields: Mapping[str, Iterable[str]]) -> list[Branch]:
    """Return the branches for `ui.tree`, with a branch for each topic.

    The id of a leaf is the name of its curve, e.g. `/turtle1/pose.x`. A topic without known numbers
    is a leaf too. Its id is the name of the topic, which means all numbers of its first message.

    Args:
        fields: The paths of each topic's numbers, e.g. `linear.x` and `covariance[0]`.
    """
    topics = []
    for topic, paths in fields.items():
        top: Branch = {"id": topic, "label": topic}
        for path in paths:
            _put(top, path, f"{topic}.{path}")
        topics.append(top)
    return topics


def _put(branch: Branch, path: str, name: str) -> None:
    parts = re.findall(r"[^.\[]+|\[\d+\]", path)
    for part in parts[:-1]:
        branch = _child(branch, part, f"{branch['id']}/{part}")
    _child(branch, parts[-1], name)


def _child(branch: Branch, label: str, key: str) -> Branch:
    children: list[Branch] = branch.setdefault("children", [])
    if children and children[-1]["label"] == label:  # the fields of a child follow each other
        return children[-1]
    children.append({"id": key, "label": label})
    return children[-1]
