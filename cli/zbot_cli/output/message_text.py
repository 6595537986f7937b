"""Formatter of messages and service events: YAML as ros2 prints it, CSV, JSON, or one field."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces.field_path import FieldPath, is_message
from zbot.interfaces.plain_value import (
    Shortening,
    csv_values,
    items_of,
    json_value,
    plain,
    shown_item,
)
from zbot.interfaces.yaml_text import Flow, dump
from zbot.node.service_introspection import Step

if TYPE_CHECKING:
    from zbot.node.message_info import MessageInfo

SEPARATOR = "---\n"
_EVENT_NAMES = {step.value: step.name for step in Step}


@dataclass(frozen=True)
class Form(Shortening):
    """Form in which messages are printed. If `length` is `None`, nothing is shortened."""

    length: int | None = 128
    csv: bool = False
    fields: tuple[str, ...] = ()
    raw: bool = False
    filter_expression: str | None = None
    with_info: bool = False
    clear: bool = False
    json: bool = False
    losses: bool = True


class Formatter:
    """Formatter of messages. Each text ends with a newline.

    Args:
        form: The form of the texts.
        with_topic: Whether each text contains the name of its topic.

    Raises:
        FieldPathError: A field that `form` selects is not a valid path.
    """

    def __init__(self, form: Form, *, with_topic: bool = False) -> None:
        self._form = form
        self._with_topic = with_topic
        self._paths = [FieldPath(text) for text in form.fields]

    def check(self, message_type: type[Any]) -> None:
        """Check that messages of a type have the fields that the form selects.

        Raises:
            FieldPathError: The messages lack a field.
        """
        if not self._form.raw:
            for path in self._paths:
                path.check(message_type)

    def subject(self, message: Any) -> Any:
        """Return the value of `m` in a filter: the message, or the one field that is selected."""
        return self._paths[0].select(message) if len(self._paths) == 1 else message

    def text(self, topic: str, message: Any, info: MessageInfo) -> str:
        """Return a message as text.

        Args:
            topic: The topic of the message.
            message: The message, or its bytes if the form is raw.
            info: Times and sequence numbers of the message.
        """
        form = self._form
        if form.json and not form.raw:
            return self._json_line(topic, message, info)
        head = f"# {topic}\n" if self._with_topic and not form.csv else ""
        if form.raw:
            return head + _info_text(form, info) + f"{message}\n{SEPARATOR}"
        parts = [path.select(message) for path in self._paths] or [message]
        if not form.csv:
            texts = (_value_text(form, part) for part in parts)
            return "".join((head, _info_text(form, info), *texts, SEPARATOR))
        head = f"{topic}," if self._with_topic else ""
        return "".join(head + _csv_line(form, part, info) for part in parts)

    def _json_line(self, topic: str, message: Any, info: MessageInfo) -> str:
        parts = [json_value(path.select(message)) for path in self._paths] or [json_value(message)]
        value = parts[0] if len(parts) == 1 else parts
        if self._form.with_info:
            value = {"topic": topic, "info": _info_facts(info), "message": value}
        elif self._with_topic:
            value = {"topic": topic, "message": value}
        return json.dumps(value, ensure_ascii=False, allow_nan=False) + "\n"


def _info_facts(info: MessageInfo) -> dict[str, object]:
    gid = info["publisher_gid"]
    facts = {key: value for key, value in info.items() if key != "publisher_gid"}
    return facts | {"gid": None if gid is None else gid["data"].hex()}


# -- YAML ----------------------------------------------------------------------------------------


def _value_text(form: Form, value: Any) -> str:
    if is_message(value):
        return dump(plain(value, form))
    if isinstance(value, (str, bytes)) or not hasattr(value, "__len__"):
        return f"{shown_item(value, None)}\n"
    items = items_of(value)
    if items and is_message(items[0]):
        return dump([plain(item, form) for item in items])
    # A list of scalars that was selected by name is not shortened, and is printed on one line.
    return dump(Flow(shown_item(item, None) for item in items))


def _info_text(form: Form, info: MessageInfo) -> str:
    return dump(dict(sorted(info.items()))) + SEPARATOR if form.with_info else ""


# -- CSV -----------------------------------------------------------------------------------------


def _csv_line(form: Form, value: Any, info: MessageInfo) -> str:
    head: tuple[int, ...] = ()
    if form.with_info:
        head = (
            info["source_timestamp"],
            info["received_timestamp"],
            info["publication_sequence_number"],
            info["reception_sequence_number"],
        )
    return ",".join((*map(str, head), *csv_values(value, form))) + "\n"


def event_json(event: Any) -> dict[str, Any]:
    """Return an event as a value for JSON."""
    return _named(json_value(event))


def event_text(event: Any, form: Form) -> str:
    """Return an event as YAML, as `ros2 service echo` and `ros2 action echo` print it."""
    return dump(_named(plain(event, form))) + SEPARATOR


def _named(event: dict[str, Any]) -> dict[str, Any]:
    number = event["info"]["event_type"]
    event["info"]["event_type"] = _EVENT_NAMES.get(number, number)
    return event
