"""Conversion from the text in an input to the value of a message field, and back."""

from __future__ import annotations

import math
from decimal import Decimal
from typing import TYPE_CHECKING, Any, Union

import yaml

from zbot.errors import ZbotError, shortened
from zbot.interfaces import FieldType, MessageSpec, get_message, spec_of
from zbot.interfaces.spec import FLOAT32_MAX, INTEGER_RANGES
from zbot.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.interfaces import Field

#: Content of an input, e.g. the state of a checkbox. None if the input is empty.
Entry = Union[str, bool, int, float, None]  # noqa: UP007 - evaluated at run time on Python 3.10

TIME = "builtin_interfaces/msg/Time"
DURATION = "builtin_interfaces/msg/Duration"
NOW = "now"

_BYTE_RANGE = (0, 255)
_TRUE = frozenset({"true", "yes", "on", "1"})
_FALSE = frozenset({"false", "no", "off", "0", ""})
_YAML_NUMBERS = {".nan": "nan", ".inf": "inf", "-.inf": "-inf"}
_LONGEST_SHOWN_ARRAY = 16
_NANOSECONDS = 10**9
_MOST_SECONDS = 1e12  # larger than every time and duration


class EntryError(ZbotError, ValueError):
    """The content of an input does not fit its field.

    Attributes:
        path: The field, e.g. `linear.x`.
        reason: The error's text without the field's path.
    """

    def __init__(self, path: str, reason: str) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"{path}: {reason}")


def integer_range(base: str) -> tuple[int, int] | None:
    """Return the smallest and the largest value of an integer type, or None for other types."""
    return _BYTE_RANGE if base == "byte" else INTEGER_RANGES.get(base)


def read(kind: FieldType, entry: Entry, path: str, now_ns: Callable[[], int]) -> Any:
    """Return the value of a field for an entry.

    Args:
        kind: The field's type. If it is a message, it must be a time or a duration.
        entry: The content of the input.
        path: The field's path, for errors.
        now_ns: Function that returns the time for `now`, in nanoseconds since the epoch.

    Raises:
        EntryError: The entry does not fit.
    """
    text = "" if entry is None else str(entry).strip()
    if kind.kind != "scalar":
        return _list(kind, text, path)
    if kind.base in {TIME, DURATION}:
        return _instant(kind.base, text, path, now_ns)
    if kind.base == "bool":
        return _bool(text, path)
    if kind.is_string:
        return _string(kind, "" if entry is None else str(entry), path)
    return _number(kind, text, path)


def _bool(text: str, path: str) -> bool:
    word = text.lower()
    if word not in _TRUE | _FALSE:
        raise EntryError(path, f"write true or false, not {text!r}")
    return word in _TRUE


def _string(kind: FieldType, text: str, path: str) -> str:
    bound = kind.string_bound
    if bound and len(text) > bound:
        raise EntryError(path, f"write at most {bound} characters, not {len(text)}")
    try:
        text.encode()
    except UnicodeEncodeError:
        raise EntryError(path, "write only characters that UTF-8 can hold") from None
    return text


def _number(kind: FieldType, text: str, path: str) -> Any:
    if not text:
        raise EntryError(path, "it is empty: write a number")
    bounds = integer_range(kind.base)
    if bounds is None:
        return _float(kind, text, path)
    number, (low, high) = _integer(text, path), bounds
    if not low <= number <= high:
        raise EntryError(path, f"write a number from {low} to {high} ({kind.base}), not {text}")
    return bytes([number]) if kind.base == "byte" else number


def _integer(text: str, path: str) -> int:
    try:
        return int(text, 0 if text[:2].lower() in {"0x", "0b", "0o"} else 10)
    except ValueError:
        number = _parsed_float(text, path)
    if not number.is_integer():
        raise EntryError(path, f"write a whole number, not {text}")
    return int(number)


def _float(kind: FieldType, text: str, path: str) -> float:
    number = _parsed_float(text, path)
    if math.isinf(number) and "inf" not in text.lower():
        raise EntryError(path, f"{shortened(text)} is too large for a {kind.base}")
    if kind.base == "float32" and math.isfinite(number) and abs(number) > FLOAT32_MAX:
        raise EntryError(path, f"{text} is too large for a float32")
    return number


def _parsed_float(text: str, path: str) -> float:
    try:
        return float(_YAML_NUMBERS.get(text.lower(), text))
    except ValueError:
        pointed = text.replace(",", ".")
        hint = f"{pointed} with a point" if text.count(",") == 1 else "a number"
        raise EntryError(path, f"write {hint}, not {text!r}") from None


def _instant(base: str, text: str, path: str, now_ns: Callable[[], int]) -> Any:
    message: Any = get_message(base)()
    is_now = text == NOW and base == TIME
    nanoseconds = now_ns() if is_now else _nanoseconds(text or "0", path)
    sec, nanosec = divmod(nanoseconds, _NANOSECONDS)
    try:
        message.sec, message.nanosec = sec, nanosec
    except ValueError:
        raise EntryError(path, f"{text} s does not fit into {base}") from None
    return message


def _nanoseconds(text: str, path: str) -> int:
    number = _parsed_float(text, path)
    if not abs(number) < _MOST_SECONDS:
        raise EntryError(path, f"write seconds, not {shortened(text)}")
    return int(Decimal(text.strip(".")) * _NANOSECONDS)  # a float would be exact only to 200 ns


def _list(kind: FieldType, text: str, path: str) -> list[Any]:
    if not text and kind.kind == "array":
        return [_zero(kind)] * kind.size
    # Users may leave out the brackets: `1, 2, 3`.
    bare = text if text.startswith("[") else f"[{text}]"
    try:
        # `no` stays a string in a string[].
        values = read_yaml(bare, as_strings=True)
    except YamlError:
        raise EntryError(path, "write a list: [1, 2, 3]") from None
    return _elements(kind, values, path)


def _elements(kind: FieldType, values: Any, path: str) -> list[Any]:
    if not isinstance(values, list):
        raise EntryError(path, "write a list: [1, 2, 3]")
    if kind.kind == "array" and len(values) != kind.size:
        raise EntryError(path, f"write {kind.size} elements, not {len(values)}")
    if kind.kind == "sequence" and kind.size and len(values) > kind.size:
        raise EntryError(path, f"write at most {kind.size} elements, not {len(values)}")
    one = FieldType(kind.base, "scalar", 0, kind.string_bound)
    return [_element(one, value, f"{path}[{index}]") for index, value in enumerate(values)]


def _element(kind: FieldType, value: Any, path: str) -> Any:
    """Return the value of a list's element. Every scalar in `value` is a string."""
    if kind.kind != "scalar":
        return _elements(kind, value, path)
    if isinstance(value, str) and (not kind.is_message or kind.base in {TIME, DURATION}):
        return read(kind, value, path, lambda: 0)
    if not kind.is_message:
        raise EntryError(path, f"write a {kind.base}, not {flow(value)}")
    if not isinstance(value, dict):
        raise EntryError(path, f"write the fields of {kind.base}: {_example(kind.base)}")
    return _nested(kind.base, value, path)


def _nested(type_name: str, values: dict[str, Any], path: str) -> Any:
    message: Any = get_message(type_name)()
    types = {field.name: field.type for field in _fields(type_name)}
    for name, value in values.items():
        if name not in types:
            known = f"its fields are {', '.join(types)}" if types else "it has none"
            raise EntryError(f"{path}.{name}", f"{type_name} has no such field; {known}")
        setattr(message, name, _element(types[name], value, f"{path}.{name}"))
    return message


def _fields(type_name: str) -> Sequence[Field]:
    spec = spec_of(get_message(type_name))
    assert isinstance(spec, MessageSpec)
    return spec.fields


def _example(type_name: str) -> str:
    return f"{{{', '.join(f'{field.name}: ...' for field in _fields(type_name))}}}"


def _zero(kind: FieldType) -> Any:
    if kind.is_message:
        return get_message(kind.base)()
    if kind.is_string:
        return ""
    return {"bool": False, "byte": b"\0", "float32": 0.0, "float64": 0.0}.get(kind.base, 0)


def show(kind: FieldType, value: Any) -> str:
    """Return the text that an input shows for a value. `read` converts the text back.

    The text is empty for a long fixed-size array of zeros.
    """
    if kind.kind != "scalar":
        return _shown_list(kind, plain(value))
    if kind.base in {TIME, DURATION}:
        return _shown_instant(value.sec * _NANOSECONDS + value.nanosec)
    return _shown_scalar(plain(value))


def _shown_instant(nanoseconds: int) -> str:
    sec, nanosec = divmod(abs(nanoseconds), _NANOSECONDS)
    sign = "-" if nanoseconds < 0 else ""
    return f"{sign}{sec}.{nanosec:09}".rstrip("0").rstrip(".")


def _shown_list(kind: FieldType, values: list[Any]) -> str:
    if kind.kind == "array" and len(values) > _LONGEST_SHOWN_ARRAY and not any(values):
        return ""
    return flow(values)


def _shown_scalar(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def flow(value: Any) -> str:
    """Return a plain value (see `plain`) as YAML on one line, e.g. for a command line."""
    text = yaml.safe_dump(
        value, default_flow_style=True, allow_unicode=True, sort_keys=False, width=2**31 - 1
    )
    return text.removesuffix("\n").removesuffix("\n...")


def plain(value: Any) -> Any:
    """Return a field's value, converted to numbers, strings, lists and dictionaries."""
    if isinstance(value, (str, bool, int, float)):
        return value
    if hasattr(type(value), "get_fields_and_field_types"):
        return {name: plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if hasattr(value, "tolist"):  # ndarray and array.array
        return value.tolist()
    if isinstance(value, bytes) and len(value) == 1:
        return value[0]
    return [plain(item) for item in value]
