"""Values on the command line: YAML, JSON or `linear.x=2` words become a message."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import yaml

from zbot.errors import ZbotError
from zbot.interfaces import get_message, spec_of
from zbot.names import nearest

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces import FieldType

_Loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_ASSIGNMENT = re.compile(r"(?P<path>[A-Za-z_][\w.]*)=(?P<value>.*)\Z", re.DOTALL)
_HEADER = "std_msgs/msg/Header"
_TIME = "builtin_interfaces/msg/Time"


class ValuesError(ZbotError):
    """The values on a command line are no YAML, or no dictionary."""

    def __init__(self, text: str, hint: str | None = None) -> None:
        self.hint = hint
        super().__init__(text)


class PopulateError(ZbotError):
    """A value does not fit the message."""

    def __init__(self, reason: str, hint: str | None = None) -> None:
        self.hint = hint
        super().__init__(f"Failed to populate field: {reason}")


def populate(message_type: type[Any], text: str, now_ns: Callable[[], int]) -> Any:
    """Return a message made from text; fields that are not named keep their defaults.

    Args:
        message_type: Message class.
        text: YAML (of which JSON is a part), or words like `linear.x=2`; may be empty.
        now_ns: What `header: auto` and `stamp: now` stand for, nanoseconds since the epoch.

    Raises:
        ValuesError: The text is no dictionary in YAML.
        PopulateError: A field does not exist, or a value does not fit it.
    """
    values = parse(text)
    message = message_type()
    _fill(message, values, now_ns, "")
    return message


def parse(text: str) -> dict[str, Any]:
    """Return the dictionary that a text stands for.

    Raises:
        ValuesError: It is none.
    """
    words = text.split()
    if words and all(map(_ASSIGNMENT.match, words)):
        return _assignments(words)
    try:
        values = yaml.load(text, Loader=_Loader)  # noqa: S506 - a safe loader, in C where there is one
    except yaml.YAMLError as exc:
        raise _syntax_error(text, exc) from None
    if values is None:
        return {}
    if not isinstance(values, dict):
        hint = "put a blank after the colon: 'data: hello'" if ":" in text else None
        raise ValuesError("The passed value needs to be a dictionary in YAML format", hint)
    return values


def split_documents(text: str) -> list[str]:
    """Return the documents of a YAML stream, such as saved output of `zbot topic echo`."""
    parts = re.split(r"^---[ \t]*$", text, flags=re.MULTILINE)
    return [part for part in parts if part.strip()]


def _assignments(words: list[str]) -> dict[str, Any]:
    values: dict[str, Any] = {}
    for word in words:
        match = _ASSIGNMENT.match(word)
        assert match is not None
        *path, last = match["path"].split(".")
        place = values
        for part in path:
            place = place.setdefault(part, {})
        place[last] = parse_scalar(match["value"])
    return values


def parse_scalar(text: str) -> Any:
    """Return what YAML makes of one value; the text itself where YAML can make nothing of it."""
    try:
        return yaml.load(text, Loader=_Loader)  # noqa: S506 - as above
    except yaml.YAMLError:
        return text


def _syntax_error(text: str, exc: yaml.YAMLError) -> ValuesError:
    mark = getattr(exc, "problem_mark", None)
    problem = getattr(exc, "problem", None) or "it is no YAML"
    where = "" if mark is None else f" (line {mark.line + 1}, column {mark.column + 1})"
    hint = 'write it like "{linear: {x: 2.0}}", with a blank after each colon'
    line = "" if mark is None else _pointer(text, mark)
    return ValuesError(f"The values are no YAML: {problem}{where}{line}", hint)


def _pointer(text: str, mark: Any) -> str:
    lines = text.splitlines()
    if mark.line >= len(lines) or len(lines[mark.line]) > 200:
        return ""
    return f"\n  {lines[mark.line]}\n  {' ' * mark.column}^"


def _fill(message: Any, values: dict[str, Any], now_ns: Callable[[], int], path: str) -> None:
    kinds = {field.name: field.type for field in spec_of(type(message)).fields}  # type: ignore[union-attr]
    for key, value in values.items():
        name = str(key)
        if name not in kinds:
            raise _unknown_field(message, name, value, list(kinds))
        try:
            setattr(message, name, _value(kinds[name], value, now_ns, f"{path}{name}"))
        except (TypeError, ValueError, OverflowError) as exc:
            raise PopulateError(str(exc)) from None


def _unknown_field(message: Any, name: str, value: Any, known: list[str]) -> PopulateError:
    if ":" in name and value is None:
        before, _, after = name.partition(":")
        hint = f"put a blank after the colon: {before}: {after}"
    else:
        guess = nearest(name, known)
        fields = ", ".join(known) or "none"
        hint = f"did you mean '{guess}'?" if guess else f"its fields are {fields}"
    reason = f"'{type(message).__name__}' object has no attribute '{name}'"
    return PopulateError(reason, hint)


def _value(kind: FieldType, value: Any, now_ns: Callable[[], int], path: str) -> Any:
    if kind.kind != "scalar":
        if not isinstance(value, list):
            raise PopulateError(f"{path} is {kind.text}: give it a list, not {value!r}")
        one = type(kind)(kind.base, "scalar", 0, kind.string_bound)
        return [_value(one, item, now_ns, f"{path}[{index}]") for index, item in enumerate(value)]
    if kind.is_message:
        return _nested(kind, value, now_ns, path)
    return _scalar(kind, value, path)


def _nested(kind: FieldType, value: Any, now_ns: Callable[[], int], path: str) -> Any:
    message: Any = get_message(kind.base)()
    if (kind.base, value) == (_HEADER, "auto"):
        value = {"stamp": "now"}
    if (kind.base, value) == (_TIME, "now"):
        message.sec, message.nanosec = divmod(now_ns(), 10**9)
        return message
    if not isinstance(value, dict):
        raise PopulateError(
            f"Value '{value}' is expected to be a dictionary but is a {type(value).__name__}",
            f"{path} is a {kind.base}: write {path}: {{...}}",
        )
    _fill(message, value, now_ns, f"{path}.")
    return message


def _scalar(kind: FieldType, value: Any, path: str) -> Any:
    base = kind.base
    if kind.is_string:
        return value if isinstance(value, str) else _as_text(value)
    if base == "bool":
        if isinstance(value, (bool, int)) and value in {0, 1}:
            return bool(value)
        raise PopulateError(f"{path} is a bool: give it true or false, not {value!r}")
    if base == "byte":
        return bytes([_integer(value, path)])
    return float(value) if base.startswith("float") else _integer(value, path)


def _as_text(value: Any) -> str:
    # YAML read a word as something else; the user meant the word.
    return str(value).lower() if isinstance(value, bool) else "" if value is None else str(value)


def _integer(value: Any, path: str) -> int:
    if isinstance(value, float) and not value.is_integer():
        raise PopulateError(f"{path} is a whole number, not {value!r}")
    if isinstance(value, (dict, list)) or value is None:
        raise PopulateError(f"{path} is a number, not {value!r}")
    return int(value)
