"""Differences between two definitions of one type, as a sentence for users."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.interfaces.definition_limits import with_parts
from zbot.interfaces.spec import MessageSpec

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.interfaces.spec import InterfaceSpec

_MOST_NAMED = 4


def difference(here: Iterable[InterfaceSpec], there: Iterable[InterfaceSpec]) -> str:
    """Return how the definitions of a type differ, e.g. ``in a/msg/B, `x` is only here``.

    Args:
        here: The definitions of the type and of the types inside it on this machine.
        there: The definitions of another node. Types that only one side has are left out.

    Returns:
        The text, or an empty string if all fields are equal.
    """
    own, other = _messages(here), _messages(there)
    found = [
        f"in {name}, {text}"
        for name in sorted(own.keys() & other.keys())
        for text in _differences(own[name], other[name])
    ]
    more = f", and {len(found) - _MOST_NAMED} more" if len(found) > _MOST_NAMED else ""
    return "; ".join(found[:_MOST_NAMED]) + more


def _messages(specs: Iterable[InterfaceSpec]) -> dict[str, MessageSpec]:
    parts = with_parts(specs).items()
    return {name: spec for name, spec in parts if isinstance(spec, MessageSpec)}


def _differences(here: MessageSpec, there: MessageSpec) -> Iterator[str]:
    own = {field.name: field.type.text for field in here.fields}
    other = {field.name: field.type.text for field in there.fields}
    for name in own | other:
        if name not in other:
            yield f"`{name}` is only here"
        elif name not in own:
            yield f"`{name}` is only there"
        elif own[name] != other[name]:
            yield f"`{name}` is {own[name]} here and {other[name]} there"
    if own == other and list(own) != list(other):
        yield "the fields have another order"
