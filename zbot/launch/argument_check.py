"""Type checks for the arguments of custom launch actions, as in `launch.utilities`."""

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
    """Check that an argument has one of the given types.

    Args:
        argument: The value.
        types: One type, or several types.
        argument_name: The argument's name, for the error text.
        caller: The name of the function or class that takes the argument.

    Raises:
        EntityTypeError: The argument has another type.
    """
    allowed = (types,) if isinstance(types, type) else tuple(types)
    if not isinstance(argument, allowed):
        where = f"{caller}: {argument_name}" if caller else argument_name
        raise EntityTypeError(where, " or ".join(each.__name__ for each in allowed), argument)


def is_a(obj: object, entity_type: type[Any]) -> bool:
    """Return whether an object is an instance of a type."""
    return isinstance(obj, entity_type)


def is_a_subclass(obj: object, entity_type: type[Any]) -> bool:
    """Return whether a class, or the class of an object, is derived from a type."""
    return issubclass(obj if isinstance(obj, type) else type(obj), entity_type)


def isclassinstance(obj: object) -> bool:
    """Return True, because in Python every object is an instance of a class."""
    return isinstance(obj, object)
