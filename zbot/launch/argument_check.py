"""What launch files with classes of their own check their arguments with."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.errors import EntityTypeError

if TYPE_CHECKING:
    from collections.abc import Iterable


def ensure_argument_type(
    argument: object,
    types: type[Any] | Iterable[type[Any]],
    argument_name: str,
    caller: str | None = None,
) -> None:
    """Refuse an argument that is of none of some types.

    Args:
        argument: The value.
        types: One type, or several.
        argument_name: What the argument is called.
        caller: What it was given to.

    Raises:
        EntityTypeError: It is of none of them.
    """
    allowed = (types,) if isinstance(types, type) else tuple(types)
    if not isinstance(argument, allowed):
        where = f"{caller}: {argument_name}" if caller else argument_name
        raise EntityTypeError(where, " or ".join(each.__name__ for each in allowed), argument)


def is_a(obj: object, entity_type: type[Any]) -> bool:
    """Return whether an object is of a type."""
    return isinstance(obj, entity_type)


def is_a_subclass(obj: object, entity_type: type[Any]) -> bool:
    """Return whether an object, or what it is an object of, is derived from a type."""
    return issubclass(obj if isinstance(obj, type) else type(obj), entity_type)


def isclassinstance(obj: object) -> bool:
    """Return whether an object is one of a class, which all are."""
    return isinstance(obj, object)
