"""Descriptions of types for web programs, in the form of `rosapi_msgs/msg/TypeDef`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces import FieldType, get_message, message_spec_of
from zbot.interfaces.plain_value import json_value

if TYPE_CHECKING:
    from zbot.interfaces import MessageSpec


def type_details(message_type: type[Any]) -> list[dict[str, Any]]:
    """Return the description of a message's type, followed by those of the types inside it."""
    found: dict[str, dict[str, Any]] = {}
    _add(message_type, found)
    return list(found.values())


def _add(message_type: type[Any], found: dict[str, dict[str, Any]]) -> None:
    spec = message_spec_of(message_type)
    if spec.name in found:
        return
    found[spec.name] = _details(spec, message_type())
    for field in spec.fields:
        if field.type.is_message:
            _add(get_message(field.type.base), found)


def _details(spec: MessageSpec, example: Any) -> dict[str, Any]:
    types = [field.type for field in spec.fields]
    return {
        "type": str(FieldType(spec.name)),
        "fieldnames": [field.name for field in spec.fields],
        "fieldtypes": [str(FieldType(kind.base)) for kind in types],
        "fieldarraylen": [-1 if kind.kind == "scalar" else _length(kind) for kind in types],
        "examples": [_example(getattr(example, field.name), field.type) for field in spec.fields],
        "constnames": [constant.name for constant in spec.constants],
        "constvalues": [str(json_value(constant.value)) for constant in spec.constants],
    }


def _length(kind: FieldType) -> int:
    return kind.size if kind.kind == "array" else 0


def _example(value: Any, kind: FieldType) -> str:
    if kind.kind != "scalar":
        return "[]"
    return "{}" if kind.is_message else str(json_value(value))
