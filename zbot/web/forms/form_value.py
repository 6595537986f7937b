"""Conversion from the text in an input to the value of a message field, and back."""

from __future__ import annotations

from decimal import Decimal
from typing import TYPE_CHECKING, Any, Union

from zbot.errors import shortened
from zbot.interfaces.message_reader import FieldMisfitError, number_with_comma
from zbot.interfaces.plain_value import items_of, octets_of
from zbot.interfaces.slot import Slot, walk
from zbot.interfaces.spec import INTEGER_RANGES
from zbot.interfaces.yaml_message import Tree, Word, YamlReader, tree_of
from zbot.interfaces.yaml_text import CollectionNode, ScalarNode, YamlError, compose, dump

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces import FieldType

#: Content of an input, e.g. the state of a checkbox. None if the input is empty.
Entry = Union[str, bool, int, float, None]  # noqa: UP007 - evaluated at run time on Python 3.10

TIME = "builtin_interfaces/msg/Time"
DURATION = "builtin_interfaces/msg/Duration"
NOW = "now"

#: Longest array of zeros that is shown.
_LONGEST_SHOWN_ARRAY = 16
#: Longest list whose elements are shown. That takes 5 ms, and other pages wait meanwhile.
_MOST_SHOWN = 1000
#: Longest text that is read as YAML. That takes 50 ms, and other pages wait meanwhile.
_MOST_CHARACTERS = 10_000
_NANOSECONDS = 10**9
_MOST_SECONDS = 1e12  # larger than every time and duration


def integer_range(base: str) -> tuple[int, int] | None:
    """Return the smallest and the largest value of an integer type, or None for other types."""
    return INTEGER_RANGES.get("uint8" if base == "byte" else base)


def read(kind: FieldType, entry: Entry, path: str, now_ns: Callable[[], int]) -> Any:
    """Return the value of a field for an entry.

    Args:
        kind: The field's type. If it is a message, it must be a time or a duration.
        entry: The content of the input.
        path: The field's path, for errors.
        now_ns: Function that returns the time for `now`, in nanoseconds since the epoch.

    Raises:
        FieldMisfitError: The entry does not fit.
    """
    text = "" if entry is None else str(entry)
    slot = Slot(path, kind)
    if kind.kind == "array" and not text.strip():
        return [_zero(slot) for _ in range(kind.size)]
    return _Reader(now_ns).value(slot, _tree(slot, text), path)


def _tree(slot: Slot, text: str) -> Tree:
    """Return the text of an input as YAML. A text that is not YAML is one word."""
    if slot.type.is_string and not slot.is_list:
        return Word(text, text)
    text = text.strip()
    if len(text) > _MOST_CHARACTERS:
        sentence = f"{slot.name} has {len(text):,} characters, and at most {_MOST_CHARACTERS:,} fit"
        raise FieldMisfitError(slot.name, sentence, "use a program instead")
    # Users may leave out the brackets: `1, 2, 3`.
    yaml = f"[{text}]" if slot.is_list and not text.startswith("[") else text
    try:
        node = compose(yaml)
        if isinstance(node, CollectionNode if slot.is_list else ScalarNode):
            return tree_of(node, yaml)
    except YamlError:
        pass
    return Word(text, text)


def _zero(slot: Slot) -> Any:
    if slot.is_message:
        return slot.message_type()
    if slot.type.is_string:
        return ""
    return {"bool": False, "byte": b"\0", "float32": 0.0, "float64": 0.0}.get(slot.type.base, 0)


class _Reader(YamlReader):
    """Reader of entries. A time is written in seconds, and an empty checkbox is false."""

    def __init__(self, now_ns: Callable[[], int]) -> None:
        super().__init__()
        self._now_ns = now_ns

    def leaf(self, slot: Slot, value: Tree) -> Any:
        if slot.type.base == "bool" and isinstance(value, Word) and not value.text:
            return False
        return super().leaf(slot, value)

    def nested(self, slot: Slot, value: Tree, path: str) -> Any:
        if slot.type.base not in {TIME, DURATION} or not isinstance(value, Word):
            return super().nested(slot, value, path)
        is_now = value.text == NOW and slot.type.base == TIME
        nanoseconds = self._now_ns() if is_now else _nanoseconds(value.text or "0", path)
        sec, nanosec = divmod(nanoseconds, _NANOSECONDS)
        try:
            return slot.message_type(sec=sec, nanosec=nanosec)
        except ValueError:
            raise FieldMisfitError(
                path, f"{path} is a {slot.type.base}: {value.text} s does not fit"
            ) from None


def _nanoseconds(text: str, path: str) -> int:
    try:
        seconds = Decimal(text)  # a float would be exact only to 200 ns
    except ArithmeticError:
        seconds = Decimal("nan")
    # `abs` would raise an error for the largest exponents.
    if not seconds.is_finite() or seconds.copy_abs() >= _MOST_SECONDS:
        hint = number_with_comma(path.rpartition(".")[2], text)
        raise FieldMisfitError(path, f"{path} must be seconds, not {shortened(text)}", hint)
    return int(seconds * _NANOSECONDS)


def show(kind: FieldType, value: Any) -> str:
    """Return the text that an input shows for a value. `read` converts the text back.

    The text is empty for a long fixed-size array of zeros. For other lists that are too long (see
    `is_too_long`), the text is the number of elements, which cannot be converted back.
    """
    if kind.kind != "scalar":
        return _shown_list(kind, value)
    if kind.base in {TIME, DURATION}:
        return _shown_instant(value.sec * _NANOSECONDS + value.nanosec)
    return _shown_scalar(plain(kind, value))


def _shown_instant(nanoseconds: int) -> str:
    sec, nanosec = divmod(abs(nanoseconds), _NANOSECONDS)
    sign = "-" if nanoseconds < 0 else ""
    return f"{sign}{sec}.{nanosec:09}".rstrip("0").rstrip(".")


def is_too_long(kind: FieldType, value: Any) -> bool:
    """Return whether a value is a list that has too many elements to be shown and changed."""
    return kind.kind != "scalar" and len(value) > _MOST_SHOWN


def _shown_list(kind: FieldType, value: Any) -> str:
    is_long_array = kind.kind == "array" and len(value) > _LONGEST_SHOWN_ARRAY
    if is_long_array and _has_only_zeros(kind, value):
        return ""
    return f"[{len(value):,} elements]" if is_too_long(kind, value) else flow(plain(kind, value))


def _has_only_zeros(kind: FieldType, value: Any) -> bool:
    if not kind.is_message:
        return not any(plain(kind, value))
    zero = _zero(Slot("", kind))
    return all(item == zero for item in value)


def _shown_scalar(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def flow(value: Any) -> str:
    """Return a plain value (see `plain`) as YAML on one line, e.g. for a command line."""
    return dump(value, flow_style=True).removesuffix("\n").removesuffix("\n...")


def plain(kind: FieldType, value: Any) -> Any:
    """Return a field's value, converted to numbers, strings, lists and dictionaries."""
    if kind.is_message and kind.kind == "scalar":
        return walk(value, _leaf)
    return _leaf(value, Slot("", kind))


def _leaf(value: Any, slot: Slot) -> Any:
    if slot.is_message:
        return [walk(item, _leaf) for item in value]
    if slot.is_octets:
        return list(octets_of(value, slot))
    if isinstance(value, bytes):
        return value[0]
    return items_of(value) if slot.is_list else value
