"""Attributes in which a message class or a dataclass stores its fields."""

from __future__ import annotations

import typing
from dataclasses import is_dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Mapping


class ClassLayout(NamedTuple):
    """How a class stores its fields."""

    prefix: str = "_"  #: prefix of a field's name in the attribute that stores it
    keywords: bool = False  #: whether decoding calls the constructor, as for dataclasses
    #: for a field, the name of the array method that makes the stored value, e.g. `tolist`
    conversions: Mapping[str, str] = MappingProxyType({})


def layout_of(message_class: type[Any]) -> ClassLayout:
    """Return how a message class or a dataclass stores its fields."""
    return _dataclass_layout(message_class) if is_dataclass(message_class) else ClassLayout()


def _dataclass_layout(message_class: type[Any]) -> ClassLayout:
    # A dataclass has a list or bytes where a generated message class has an array.array.
    conversions = {}
    for name, hint in typing.get_type_hints(message_class).items():
        if hint is bytes:
            conversions[name] = "tobytes"
        elif typing.get_origin(hint) is list:
            conversions[name] = "tolist"
    return ClassLayout(prefix="", keywords=True, conversions=conversions)
