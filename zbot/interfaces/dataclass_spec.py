"""Specs of messages that are defined as Python dataclasses."""

from __future__ import annotations

import dataclasses
import re
import sys
import typing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from zbot.interfaces.errors import NotAMessageTypeError
from zbot.interfaces.grammar import (
    GrammarError,
    check_field_name,
    check_interface_name,
    parse_type,
)
from zbot.interfaces.registry import register_class
from zbot.interfaces.spec import Field, FieldType, MessageSpec, Scalar

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import InterfaceSpec

_BASES: dict[Any, str] = {bool: "bool", int: "int64", float: "float64", str: "string"}
_USABLE = "bool, int, float, str, bytes, a message class, a dataclass, or a list of one of these"

_in_progress: list[type[Any]] = []


def dataclass_spec(cls: type[Any], spec_of: Callable[[type[Any]], InterfaceSpec]) -> MessageSpec:
    """Return the spec of a dataclass, and register the class under its type name.

    `int` becomes int64, `float` becomes float64, `bytes` becomes uint8[], and `list[float]` becomes
    float64[]. An annotation selects another type, e.g. `Annotated[int, "uint8"]` or
    `Annotated[list[float], "float32[9]"]`.

    Args:
        cls: The dataclass. Its type name is `<top-level module>/msg/<class>`, with the script's
            name in place of `__main__`.
        spec_of: Function that returns the spec of a field's class.

    Raises:
        NotAMessageTypeError: A field or the name of the class is not valid in a message.
    """
    if cls in _in_progress:
        raise NotAMessageTypeError(cls, "it contains itself")
    _in_progress.append(cls)
    try:
        name = f"{_package(cls)}/msg/{cls.__name__}"
        check_interface_name(name)
        spec = MessageSpec(name, _fields(cls, spec_of))
    except GrammarError as error:
        raise NotAMessageTypeError(cls, str(error)) from error
    finally:
        _in_progress.pop()
    register_class(spec, cls)
    return spec


def _fields(cls: type[Any], spec_of: Callable[[type[Any]], InterfaceSpec]) -> tuple[Field, ...]:
    try:
        hints = typing.get_type_hints(cls, include_extras=True)
    except NameError as error:
        reason = f"{error}; define the classes of its fields at the top level of a module"
        raise NotAMessageTypeError(cls, reason) from error
    fields = []
    for field in dataclasses.fields(cls):
        check_field_name(field.name)
        field_type = _field_type(hints[field.name], cls, spec_of)
        if field_type is None:
            reason = f"field {field.name!r} is {_shown(hints[field.name])}; it can be {_USABLE}"
            raise NotAMessageTypeError(cls, reason)
        fields.append(Field(field.name, field_type, _default(field, field_type)))
    return tuple(fields)


def _field_type(
    hint: Any, owner: type[Any], spec_of: Callable[[type[Any]], InterfaceSpec]
) -> FieldType | None:
    if typing.get_origin(hint) is Annotated:
        python_type, *notes = typing.get_args(hint)
        named = next((note for note in notes if isinstance(note, str)), None)
        if named is not None:
            return parse_type(named, _package(owner))
        return _field_type(python_type, owner, spec_of)
    if hint is bytes:
        return FieldType("uint8", "sequence")
    if typing.get_origin(hint) is list:
        (element,) = typing.get_args(hint)
        inner = _field_type(element, owner, spec_of)
        if inner is None or inner.kind != "scalar":
            return None
        return FieldType(inner.base, "sequence", 0, inner.string_bound)
    if hint in _BASES:
        return FieldType(_BASES[hint])
    return _message_type(hint, spec_of)


def _message_type(hint: Any, spec_of: Callable[[type[Any]], InterfaceSpec]) -> FieldType | None:
    if not isinstance(hint, type):
        return None
    if not (dataclasses.is_dataclass(hint) or hasattr(hint, "get_fields_and_field_types")):
        return None
    spec = spec_of(hint)
    return FieldType(spec.name) if isinstance(spec, MessageSpec) else None


def _default(field: dataclasses.Field[Any], field_type: FieldType) -> Scalar | None:
    value = field.default
    if field_type.kind == "scalar" and isinstance(value, (bool, int, float, str)):
        return value
    return None


def _package(cls: type[Any]) -> str:
    """Return the top-level module's name as a valid package name, e.g. `my_robot`."""
    module = cls.__module__
    if module == "__main__":
        module = _main_name()
    package = re.sub(r"[^a-z0-9]+", "_", module.partition(".")[0].lower()).strip("_")
    return package if package[:1].isalpha() else f"script_{package}".rstrip("_")


def _main_name() -> str:
    """Return the module name with which another program would import the running script."""
    main = sys.modules["__main__"]
    spec = getattr(main, "__spec__", None)
    if spec is not None:
        return str(spec.name)
    return Path(getattr(main, "__file__", None) or "main").stem


def _shown(hint: Any) -> str:
    return hint.__qualname__ if isinstance(hint, type) else str(hint)
