"""Objects for the types of fields. Their classes have the names of ROS 2's `rosidl_parser`.

Programs that handle messages of any type use these classes: `isinstance(slot, AbstractSequence)`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.interfaces.spec import FieldType

if TYPE_CHECKING:
    from collections.abc import Sequence


class AbstractType:
    """Base of all field types."""


class AbstractNestableType(AbstractType):
    """Base of the types that array and sequence elements can have."""


@dataclass(frozen=True)
class BasicType(AbstractNestableType):
    """A number or a bool, with its IDL name: `double`, `boolean`, `uint8`."""

    typename: str


@dataclass(frozen=True)
class NamedType(AbstractNestableType):
    """A type with a short name."""

    name: str


@dataclass(frozen=True, init=False)
class NamespacedType(AbstractNestableType):
    """A message, e.g. with the namespaces `['std_msgs', 'msg']` and the name `Header`."""

    namespaces: list[str]
    name: str

    def __init__(self, namespaces: Sequence[str], name: str) -> None:
        object.__setattr__(self, "namespaces", list(namespaces))
        object.__setattr__(self, "name", name)

    def __hash__(self) -> int:
        return hash(self.namespaced_name())

    def namespaced_name(self) -> tuple[str, ...]:
        """Return all parts of the name."""
        return (*self.namespaces, self.name)


class AbstractGenericString(AbstractNestableType):
    """Base of all strings."""

    def has_maximum_size(self) -> bool:
        """Return whether the length is bounded."""
        return hasattr(self, "maximum_size")


class AbstractString(AbstractGenericString):
    """Base of the types for `string`."""


class AbstractWString(AbstractGenericString):
    """Base of the types for `wstring`."""


@dataclass(frozen=True)
class BoundedString(AbstractString):
    """A `string` of at most `maximum_size` characters."""

    maximum_size: int


@dataclass(frozen=True)
class UnboundedString(AbstractString):
    """A `string` of any length."""


@dataclass(frozen=True)
class BoundedWString(AbstractWString):
    """A `wstring` of at most `maximum_size` characters."""

    maximum_size: int


@dataclass(frozen=True)
class UnboundedWString(AbstractWString):
    """A `wstring` of any length."""


@dataclass(frozen=True)
class AbstractNestedType(AbstractType):
    """Base of all types with elements."""

    value_type: AbstractNestableType

    def has_maximum_size(self) -> bool:
        """Return whether the number of elements is bounded."""
        return isinstance(self, (Array, BoundedSequence))


@dataclass(frozen=True)
class Array(AbstractNestedType):
    """An array of exactly `size` elements."""

    size: int


@dataclass(frozen=True)
class AbstractSequence(AbstractNestedType):
    """Base of types with a variable number of elements."""


@dataclass(frozen=True)
class BoundedSequence(AbstractSequence):
    """A sequence of at most `maximum_size` elements."""

    maximum_size: int


@dataclass(frozen=True)
class UnboundedSequence(AbstractSequence):
    """A sequence of any number of elements."""


def slot_type(kind: FieldType) -> AbstractType:
    """Return a field's type as an object of these classes."""
    element = _element(kind)
    if kind.kind == "array":
        return Array(element, kind.size)
    if kind.kind == "sequence":
        return BoundedSequence(element, kind.size) if kind.size else UnboundedSequence(element)
    return element


def _element(kind: FieldType) -> AbstractNestableType:
    if kind.is_message:
        *namespaces, name = kind.base.split("/")
        return NamespacedType(namespaces, name)
    bound = kind.string_bound
    if kind.base == "string":
        return BoundedString(bound) if bound else UnboundedString()
    if kind.base == "wstring":
        return BoundedWString(bound) if bound else UnboundedWString()
    return BasicType(str(FieldType(kind.base)))  # IDL's name
