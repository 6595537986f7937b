"""Reader of the lines that boards print.

A line has one of these forms:

* `temperature: 23.5`, `state: open`, `temperature 23.5`
* `temperature:23.5,humidity:41`, as for the plotter of the Arduino IDE
* `{"temperature": 23.5, "humidity": 41}`
* `/imu sensor_msgs/msg/Imu {...}`: the type, and the message in JSON or YAML
* `23.5` with a topic that the user gives, and `23.5,41` with a name for each number
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.bridge.devices.errors import DeviceError, UnreadableError
from zbot.bridge.devices.text_value import NUMBER, UNIT, word_of
from zbot.bridge.devices.topic_type import TopicType
from zbot.text.json_reader import JsonError, read_json_object
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

_NAME = r"/?[A-Za-z_][\w/-]{0,99}"
_VALUE = rf"(?:{NUMBER}|[+-]?nan|[+-]?inf|true|false|on|off)"
_PAIR = rf"{_NAME}\s*[:=]\s*{_VALUE}(?:\s*{UNIT})?"
_PAIRS = re.compile(rf"{_PAIR}(?:[\s,;|]+{_PAIR})*[\s,;|]*\Z", re.ASCII | re.IGNORECASE)
_EACH = re.compile(rf"({_NAME})\s*[:=]\s*({_VALUE})", re.ASCII | re.IGNORECASE)
_WORDS = re.compile(rf"({_NAME})\s+({_VALUE})(?:\s*{UNIT})?\Z", re.ASCII | re.IGNORECASE)
# A name of several words, e.g. `Soil moisture: 512`.
_TITLE = re.compile(r"([A-Za-z][\w -]{0,99}?)\s*:\s*(\S.*)\Z", re.ASCII)
_TYPED = re.compile(r"(/?\w[\w/]{0,246})\s+(\w+/(?:msg/)?\w+)\s+(\{.*\})\Z", re.ASCII)
# The text of a String. Other texts with a colon are messages of a boot loader, e.g. `rst:0x1 (ON)`.
_PLAIN_TEXT = re.compile(r"[^,:;={}\[\]()]{1,200}\Z")
_BETWEEN_NUMBERS = re.compile(r"[\s,;|]+")


class Reading(NamedTuple):
    """One value of a line. The name is empty for the values of a JSON object."""

    name: str
    value: Any
    kind: TopicType | None = None  #: the type, if the line names it


class LineReader:
    """Reader of the lines of one board.

    Args:
        topic: Topic of a line that is only a value. It may be empty.
        names: Topics of the numbers of a line that has only numbers.
        type_of: Returns the type of a topic, if it is known.
    """

    def __init__(
        self,
        topic: str = "",
        names: Sequence[str] = (),
        type_of: Callable[[str], TopicType | None] = lambda _: None,
    ) -> None:
        self._topic, self._names, self._type_of = topic, tuple(names), type_of

    def read(self, line: str) -> list[Reading]:
        """Return the values of a line. A text that is in no form of this module has no values.

        Raises:
            UnreadableError: The line has one of the forms, but a fault.
        """
        line = line.strip()
        if line.startswith("{") and line.endswith("}"):
            return [Reading(self._object_topic(), _json_object(line))]
        if line.endswith("}") and (match := _TYPED.match(line)):
            return [_typed(*match.groups())]
        return self._bare(line) or list(self._named(line))

    def _object_topic(self) -> str:
        return self._topic if self._topic and self._type_of(self._topic) else ""

    def _bare(self, line: str) -> list[Reading]:
        """Return the values of a line without names."""
        if self._names:
            words = [word_of(text) for text in _BETWEEN_NUMBERS.split(line.strip(" ,;|\t"))]
            if any(word.value.__class__ is str for word in words):
                return []
            if len(words) != len(self._names):
                count = len(self._names)
                raise UnreadableError(f"the number of values is not {count}, as in --names")
            return [Reading(name, word) for name, word in zip(self._names, words, strict=True)]
        if not self._topic:
            return []
        word = word_of(line)
        is_text = word.value.__class__ is str
        if is_text and not _is_text(self._type_of(self._topic)):
            return []
        return [Reading(self._topic, word)]

    def _named(self, line: str) -> Iterator[Reading]:
        if _PAIRS.match(line):
            for name, value in _EACH.findall(line):
                yield Reading(name, word_of(value))
            return
        match = _WORDS.match(line)
        if match:
            yield Reading(match[1], word_of(match[2]))
            return
        match = _TITLE.match(line)
        if match and self._is_value(match[1], match[2], line):
            yield Reading(match[1], word_of(match[2]))

    def _is_value(self, name: str, text: str, line: str) -> bool:
        """Return whether a text after a colon is a value, not a part of a sentence."""
        if _is_text(self._type_of(name)):
            return True
        if word_of(text).value.__class__ is not str:
            return True
        return " " not in name and ": " in line and _PLAIN_TEXT.match(text) is not None


def _is_text(kind: TopicType | None) -> bool:
    return kind is not None and kind.name == "std_msgs/msg/String"


def _json_object(line: str) -> dict[str, Any]:
    try:
        return read_json_object(line)
    except JsonError as error:
        raise UnreadableError("it is not valid JSON", error.reason) from None


def _typed(name: str, kind: str, text: str) -> Reading:
    try:
        known = TopicType.parse(kind)
    except DeviceError as error:
        raise UnreadableError("the type is not known", str(error), error.hint) from None
    return Reading(name, _fields(text), known)


def _fields(text: str) -> dict[str, Any]:
    try:
        return read_json_object(text)
    except JsonError:
        pass  # YAML needs no quotes, but takes much longer
    try:
        values = read_yaml(text)
    except YamlError as error:
        raise UnreadableError("it is not valid YAML", str(error)) from None
    if not isinstance(values, dict) or not all(isinstance(key, str) for key in values):
        raise UnreadableError("the message is not a dictionary")
    return values
