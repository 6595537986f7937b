"""Messages as text: YAML as `ros2 topic echo` prints it, CSV, JSON, or one field."""

from __future__ import annotations

import array
import base64
import json
import math
import re
from typing import TYPE_CHECKING, Any

import yaml

from zbot.errors import ZbotError
from zbot.interfaces import spec_of
from zbot.names import nearest

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.interfaces import FieldType
    from zbot.subscription import MessageInfo
    from zbot_cli.echo import Form

SEPARATOR = "---\n"
#: Numeric lists up to this long are shown on one line.
SHORT_LIST = 16
_STEP = re.compile(r"(?P<name>\w+)(?P<indices>(?:\[[^\[\]]*\])*)\Z")
_INDEX = re.compile(r"\[([^\[\]]*)\]")

_Base: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)


class FieldPathError(ZbotError):
    """A field that was asked for does not exist."""

    def __init__(self, path: str, reason: str, hint: str | None = None) -> None:
        self.path, self.hint = path, hint
        super().__init__(f"Invalid field '{path}': {reason}")


class _Flow(list[Any]):
    """A list that is written on one line."""


class _Dumper(_Base):  # type: ignore[misc]
    """Writes mappings in their order, and flow lists on one line."""

    def ignore_aliases(self, data: object) -> bool:  # noqa: ARG002 - PyYAML's signature
        return True


_Dumper.add_representer(
    _Flow,
    lambda dumper, data: dumper.represent_sequence("tag:yaml.org,2002:seq", data, flow_style=True),
)


def to_yaml(value: Any) -> str:
    """Return a dictionary or list of plain types as block YAML, ending with a newline."""
    text: str = yaml.dump(
        value,
        Dumper=_Dumper,
        allow_unicode=True,
        default_flow_style=False,
        sort_keys=False,
        width=2**31 - 1,
    )
    return text


def formatter(form: Form) -> Callable[[str, Any, MessageInfo], str]:
    """Return the function that turns a topic's name, a message and its info into text."""
    if form.raw:
        return lambda _, message, info: _info_text(form, info) + f"{message}\n{SEPARATOR}"
    paths = [parse_path(path) for path in form.fields]
    if form.json:
        return lambda topic, message, info: _json_line(form, paths, topic, message, info)
    show = _csv_line if form.csv else _yaml_text
    if not paths:
        return lambda _, message, info: show(form, message, info)
    return lambda _, message, info: "".join(
        show(form, select(message, path), info) for path in paths
    )


# -- fields --------------------------------------------------------------------------------------


def parse_path(path: str) -> list[str | int | slice]:
    """Return the steps of a dotted path: `poses[0].position` is poses, 0, position.

    Raises:
        FieldPathError: The path is malformed.
    """
    steps: list[str | int | slice] = []
    for part in path.split("."):
        match = _STEP.match(part)
        if match is None:
            raise FieldPathError(path, "write it like pose.position.x or ranges[0]")
        steps.append(match["name"])
        steps.extend(_index(path, text) for text in _INDEX.findall(match["indices"]))
    return steps


def _index(path: str, text: str) -> int | slice:
    try:
        numbers = [int(part) if part.strip() else None for part in text.split(":")]
    except ValueError:
        raise FieldPathError(path, f"[{text}] is no index") from None
    if len(numbers) == 1 and numbers[0] is not None:
        return numbers[0]
    if len(numbers) not in {2, 3}:
        raise FieldPathError(path, f"[{text}] is no index")
    return slice(*numbers)


def select(message: Any, path: list[str | int | slice]) -> Any:
    """Return the part of a message that a path leads to.

    Raises:
        FieldPathError: It leads nowhere.
    """
    value = message
    for step in path:
        try:
            value = getattr(value, step) if isinstance(step, str) else value[step]
        except AttributeError:
            raise _missing_field(path, value, step) from None
        except (IndexError, TypeError) as exc:
            raise FieldPathError(_path_text(path), str(exc)) from None
    return value


def _missing_field(path: list[str | int | slice], value: Any, step: Any) -> FieldPathError:
    known = list(_fields(value)) if is_message(value) else []
    guess = nearest(str(step), known)
    hint = f"did you mean '{guess}'?" if guess else None
    if hint is None and known:
        hint = f"its fields are {', '.join(known)}"
    reason = f"'{type(value).__name__}' object has no attribute '{step}'"
    return FieldPathError(_path_text(path), reason, hint)


def _path_text(path: list[str | int | slice]) -> str:
    text = ""
    for step in path:
        text += f".{step}" if isinstance(step, str) else f"[{step}]"
    return text[1:]


def is_message(value: Any) -> bool:
    """Return whether a value is a message rather than a number, string or list."""
    return hasattr(type(value), "get_fields_and_field_types") or hasattr(type(value), "SPEC")


def _fields(message: Any) -> dict[str, FieldType]:
    return {field.name: field.type for field in spec_of(type(message)).fields}  # type: ignore[union-attr]


# -- YAML ----------------------------------------------------------------------------------------


def _yaml_text(form: Form, value: Any, info: MessageInfo) -> str:
    head = _info_text(form, info)
    if is_message(value):
        return head + to_yaml(plain(value, form)) + SEPARATOR
    if isinstance(value, list) and value and is_message(value[0]):
        return head + to_yaml([plain(item, form) for item in value]) + SEPARATOR
    return f"{head}{value}\n{SEPARATOR}"


def _info_text(form: Form, info: MessageInfo) -> str:
    return to_yaml(dict(sorted(info.items()))) + SEPARATOR if form.with_info else ""


def plain(message: Any, form: Form) -> dict[str, Any]:
    """Return a message as a dictionary of what YAML can write, shortened as the form says."""
    return {
        name: _plain_value(getattr(message, name), kind, form)
        for name, kind in _fields(message).items()
    }


def _plain_value(value: Any, kind: FieldType, form: Form) -> Any:
    if isinstance(value, str):
        return _shown_string(value, form)
    if isinstance(value, (bytes, bytearray)):
        return _shown_string("".join(map(chr, value)), form)
    if kind.kind == "scalar":
        return plain(value, form) if is_message(value) else _number(value)
    if form.no_arr:
        return _array_label(value, kind)
    return _shown_list(value, form)


def _number(value: Any) -> Any:
    return value.item() if hasattr(value, "item") else value


def _shown_string(text: str, form: Form) -> str:
    if form.no_str:
        return f"<string length: <{len(text)}>>"
    if form.length is not None and len(text) > form.length:
        return text[: form.length] + "..."
    return text


def _array_label(value: Any, kind: FieldType) -> str:
    base = str(type(kind)(kind.base, "scalar", 0, kind.string_bound))
    if kind.kind == "array":
        return f"<array type: {base}[{kind.size}]>"
    bound = f"[{kind.size}]" if kind.size else ""
    return f"<sequence type: {base}{bound}, length: {len(value)}>"


def _shown_list(value: Any, form: Form) -> list[Any]:
    shown = value if form.length is None else value[: form.length]
    items: list[Any] = shown.tolist() if hasattr(shown, "tolist") else list(shown)
    numeric = isinstance(value, array.array) or hasattr(value, "dtype")
    if items and is_message(items[0]):
        items = [plain(item, form) for item in items]
    else:
        items = [_shown_item(item, form) for item in items] if not numeric else items
    if len(shown) < len(value):
        items.append("...")
    flow = form.flow_style or (numeric and len(value) <= SHORT_LIST)
    return _Flow(items) if flow else items


def _shown_item(item: Any, form: Form) -> Any:
    if isinstance(item, bytes):
        return "".join(map(chr, item))
    return _shown_string(item, form) if isinstance(item, str) else item


# -- CSV -----------------------------------------------------------------------------------------


def _csv_line(form: Form, value: Any, info: MessageInfo) -> str:
    head = ""
    if form.with_info:
        order = ("source", "received")
        times = [info[f"{word}_timestamp"] for word in order]  # type: ignore[literal-required]
        numbers = (info["publication_sequence_number"], info["reception_sequence_number"])
        head = ",".join(map(str, (*times, *numbers))) + ","
    if not is_message(value):
        return f"{head}{value}\n"
    return head + ",".join(_leaves(value, form)) + "\n"


def _leaves(value: Any, form: Form) -> Iterator[str]:
    if is_message(value):
        for name, kind in _fields(value).items():
            item = getattr(value, name)
            if form.no_arr and kind.kind != "scalar":
                yield _array_label(item, kind)
            else:
                yield from _leaves(item, form)
    elif isinstance(value, str):
        yield _shown_string(value, form)
    elif isinstance(value, (bytes, bytearray)):
        yield _shown_string("".join(map(chr, value)), form)
    elif hasattr(value, "__len__"):
        shown = value if form.length is None else value[: form.length]
        for item in shown.tolist() if hasattr(shown, "tolist") else shown:
            yield from _leaves(item, form)
        if len(shown) < len(value):
            yield "..."
    else:
        yield str(_number(value))


# -- JSON ----------------------------------------------------------------------------------------


def _json_line(
    form: Form, paths: list[list[str | int | slice]], topic: str, message: Any, info: MessageInfo
) -> str:
    values = (
        [json_value(select(message, path)) for path in paths] if paths else [json_value(message)]
    )
    value = values[0] if len(values) == 1 else values
    if form.with_info:
        value = {"topic": topic, "info": dict(info), "message": value}
    return json.dumps(value, ensure_ascii=False, allow_nan=False) + "\n"


def json_value(value: Any) -> Any:
    """Return a value as JSON has it.

    Numbers that JSON lacks (NaN, infinities) become null, and bytes base64.
    """
    if is_message(value):
        return {name: json_value(getattr(value, name)) for name in _fields(value)}
    if isinstance(value, (bytes, bytearray)):
        return base64.b64encode(value).decode()
    if isinstance(value, array.array) and value.typecode == "B":
        return base64.b64encode(value.tobytes()).decode()
    if hasattr(value, "tolist"):
        return json_value(value.tolist())
    if isinstance(value, list):
        return [json_value(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
