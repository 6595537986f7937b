"""Service events as text, with the name of the event type instead of its number."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces.plain_value import json_value, plain
from zbot.interfaces.yaml_text import dump
from zbot.node.service_introspection import Step
from zbot_cli.output.message_text import SEPARATOR

if TYPE_CHECKING:
    from zbot_cli.output.message_text import Form

_NAMES = {step.value: step.name for step in Step}


def event_json(event: Any) -> dict[str, Any]:
    """Return an event as a value for JSON."""
    return _named(json_value(event))


def event_text(event: Any, form: Form) -> str:
    """Return an event as YAML, as `ros2 service echo` and `ros2 action echo` print it."""
    return dump(_named(plain(event, form))) + SEPARATOR


def _named(event: dict[str, Any]) -> dict[str, Any]:
    number = event["info"]["event_type"]
    event["info"]["event_type"] = _NAMES.get(number, number)
    return event
