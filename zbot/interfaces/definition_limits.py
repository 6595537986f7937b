"""Limits for definitions from other machines. zbot checks the limits before it makes a class.

Definitions of a few lines can describe a message that fills the memory, e.g. if each of thirty
types contains two fields of the next type. Definitions in files of this machine have no such
limits.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.interfaces.default_size import DefaultSize, combined_size
from zbot.interfaces.errors import DefinitionLimitError
from zbot.interfaces.registry import MAX_NESTING, get_spec
from zbot.interfaces.spec import MessageSpec, parts_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.interfaces.spec import InterfaceSpec

MAX_DEFINITIONS = 1_000
MAX_FIELDS = 10_000
MAX_TEXT = 1_000_000  #: characters of all definitions together
MAX_BYTES = 16 * 2**20  #: memory of one message with default values
MAX_MESSAGES = 100_000  #: messages inside one message with default values

_TOO_DEEP = f"it has more than {MAX_NESTING} levels"


class _LimitError(Exception):
    """A definition is too large. The caller adds the name of the whole type."""


def check_text_limits(name: str, texts: Iterable[str]) -> None:
    """Check the texts of a type and of the types inside it, before they are parsed.

    Raises:
        DefinitionLimitError: There are too many texts, or they are too long.
    """
    lengths = [len(text) for text in texts]
    if len(lengths) > MAX_DEFINITIONS:
        raise DefinitionLimitError(name, f"it has more than {MAX_DEFINITIONS} parts")
    if sum(lengths) > MAX_TEXT:
        raise DefinitionLimitError(name, f"its text has more than {MAX_TEXT} characters")


def check_field_limits(name: str, fields: Sequence[int]) -> None:
    """Check the numbers of fields of a type and of the types inside it.

    Raises:
        DefinitionLimitError: There are too many types or too many fields.
    """
    if len(fields) > MAX_DEFINITIONS:
        raise DefinitionLimitError(name, f"it has more than {MAX_DEFINITIONS} parts")
    if sum(fields) > MAX_FIELDS:
        raise DefinitionLimitError(name, f"it has more than {MAX_FIELDS} fields")


def check_limits(specs: Sequence[InterfaceSpec]) -> None:
    """Check the definitions of a type and of the types inside it. The type itself is the last.

    Raises:
        DefinitionLimitError: A message would be too large or too deep. The error has the type name.
        UnknownPackageError: A type inside it is missing in `specs`, and its package is unknown.
        UnknownInterfaceError: A type inside it is missing in `specs` and in its known package.
    """
    found = with_parts(specs)
    messages = [spec for spec in found.values() if isinstance(spec, MessageSpec)]
    check_field_limits(specs[-1].name, [len(spec.fields) for spec in messages])
    measured: dict[str, DefaultSize] = {}
    try:
        for spec in messages:
            _measure(spec.name, found, measured, ())
    except _LimitError as error:
        raise DefinitionLimitError(specs[-1].name, str(error)) from None


def with_parts(specs: Iterable[InterfaceSpec]) -> dict[str, InterfaceSpec]:
    """Return specs by their names, with the parts of services and actions."""
    found: dict[str, InterfaceSpec] = {}
    waiting = list(specs)
    while waiting:
        spec = waiting.pop()
        found[spec.name] = spec
        waiting += parts_of(spec)
    return found


def _measure(
    name: str,
    specs: Mapping[str, InterfaceSpec],
    measured: dict[str, DefaultSize],
    outer: tuple[str, ...],
) -> DefaultSize:
    if name in measured:
        return measured[name]
    if name in outer:
        raise _LimitError(f"{name} contains itself")
    spec = specs.get(name) or get_spec(name)
    if len(outer) > MAX_NESTING:
        raise _LimitError(_TOO_DEEP)

    def find(inner: str) -> DefaultSize:
        return _measure(inner, specs, measured, (*outer, name))

    measured[name] = size = combined_size(spec, find)
    _check(name, size)
    return size


def _check(name: str, size: DefaultSize) -> None:
    if size.octets > MAX_BYTES:
        raise _LimitError(f"an empty {name} would need more than {MAX_BYTES} bytes")
    if size.messages > MAX_MESSAGES:
        raise _LimitError(f"an empty {name} would contain more than {MAX_MESSAGES} messages")
    if size.levels > MAX_NESTING:
        raise _LimitError(_TOO_DEEP)
