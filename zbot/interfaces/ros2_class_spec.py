"""Specs of the message classes of an installed ROS 2. The attributes of a class give its spec."""

from __future__ import annotations

import importlib
from typing import Any

from zbot.interfaces.errors import NotAMessageTypeError
from zbot.interfaces.registry import register_class
from zbot.interfaces.spec import (
    Field,
    FieldType,
    InterfaceSpec,
    Kind,
    MessageSpec,
    action_spec,
    service_spec,
)

_BASES = {"boolean": "bool", "octet": "byte", "float": "float32", "double": "float64"}


def ros2_class_spec(cls: type[Any]) -> InterfaceSpec:
    """Return the spec of a class that ROS 2's own generator made, and register the class.

    The spec has no constants, because they do not change the wire format. The classes of nested
    messages are registered too.

    Raises:
        NotAMessageTypeError: The class does not have the form of ROS 2's classes.
    """
    name = _name(cls)
    if hasattr(cls, "Goal"):
        return action_spec(
            name, message_spec(cls.Goal), message_spec(cls.Result), message_spec(cls.Feedback)
        )
    if hasattr(cls, "Request"):
        return service_spec(name, message_spec(cls.Request), message_spec(cls.Response))
    return message_spec(cls)


def message_spec(cls: type[Any]) -> MessageSpec:
    """Return the spec of a message class. See `ros2_class_spec`."""
    names = tuple(cls.get_fields_and_field_types())
    types = tuple(getattr(cls, "SLOT_TYPES", ()))
    if len(names) != len(types):
        raise NotAMessageTypeError(cls, "it has no SLOT_TYPES for its fields")
    fields = [
        Field(name, _field_type(slot_type), _default(cls, name))
        for name, slot_type in zip(names, types, strict=True)
    ]
    spec = MessageSpec(_name(cls), tuple(fields))
    register_class(spec, cls)
    return spec


def _name(cls: type[Any]) -> str:
    """Return the type name of a class: package and kind from its module, and the class name."""
    parts = cls.__module__.split(".")
    if len(parts) < 3 or parts[-2] not in {"msg", "srv", "action"}:
        reason = f"its module {cls.__module__!r} is not of the form package.msg._name"
        raise NotAMessageTypeError(cls, reason)
    return f"{parts[-3]}/{parts[-2]}/{cls.__name__}"


def _default(cls: type[Any], name: str) -> Any:
    default = getattr(cls, f"{name.upper()}__DEFAULT", None)
    if default is None or isinstance(default, (bool, int, float, str, bytes)):
        return default
    return tuple(default)


def _field_type(slot: Any) -> FieldType:
    """Return the field type for an object of `rosidl_parser.definition`.

    Only the name of the object's class is compared, so that zbot need not import this module.
    """
    match type(slot).__name__:
        case "Array":
            return _many(slot.value_type, "array", slot.size)
        case "BoundedSequence":
            return _many(slot.value_type, "sequence", slot.maximum_size)
        case "UnboundedSequence":
            return _many(slot.value_type, "sequence", 0)
        case "NamespacedType":
            return _message_type(slot)
        case "BoundedString":
            return FieldType("string", string_bound=slot.maximum_size)
        case "BoundedWString":
            return FieldType("wstring", string_bound=slot.maximum_size)
        case "UnboundedString":
            return FieldType("string")
        case "UnboundedWString":
            return FieldType("wstring")
        case _:
            name: str = slot.typename
            return FieldType(_BASES.get(name, name))


def _many(element: Any, kind: Kind, size: int) -> FieldType:
    inner = _field_type(element)
    return FieldType(inner.base, kind, size, inner.string_bound)


def _message_type(slot: Any) -> FieldType:
    module = importlib.import_module(".".join(slot.namespaces))
    message_spec(getattr(module, slot.name))
    return FieldType("/".join((*slot.namespaces, slot.name)))
