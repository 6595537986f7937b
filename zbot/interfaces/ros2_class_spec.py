"""Definitions of the classes of a real ROS 2 installation, read off the classes themselves."""

from __future__ import annotations

import importlib
from typing import Any

from zbot.interfaces import derived
from zbot.interfaces.errors import NotAMessageTypeError
from zbot.interfaces.registry import register_class
from zbot.interfaces.spec import Field, FieldType, InterfaceSpec, Kind, MessageSpec

_BASES = {"boolean": "bool", "octet": "byte", "float": "float32", "double": "float64"}


def foreign_spec(cls: type[Any]) -> InterfaceSpec:
    """Derive the definition of a class that ROS 2's own generator made.

    Constants are left out: nothing on the wire depends on them. The class, and those of the
    messages inside it, become the ones that their names stand for.

    Raises:
        NotAMessageTypeError: The class does not look like one of ROS 2's.
    """
    name = _name(cls)
    if hasattr(cls, "Goal"):
        return derived.action(
            name, message_spec(cls.Goal), message_spec(cls.Result), message_spec(cls.Feedback)
        )
    if hasattr(cls, "Request"):
        return derived.service(name, message_spec(cls.Request), message_spec(cls.Response))
    return message_spec(cls)


def message_spec(cls: type[Any]) -> MessageSpec:
    """Derive the definition of a message class; see `foreign_spec`."""
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
    """`std_srvs/srv/SetBool_Request` of the class in `std_srvs.srv._set_bool`."""
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
    """A type of rosidl_parser.definition; told by its class's name, so nothing is imported."""
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
