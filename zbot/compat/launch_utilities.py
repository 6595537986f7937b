"""Functions of `launch.utilities` for custom launch actions: checks of arguments, and a visitor."""

from __future__ import annotations

import asyncio
import os
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.launch.errors import EntityTypeError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity

#: Type of arguments that are paths.
FilePath: TypeAlias = str | bytes | os.PathLike[str] | os.PathLike[bytes]


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


def create_future(loop: asyncio.AbstractEventLoop | None) -> asyncio.Future[Any]:
    """Return a new future of an event loop. None means the loop of this thread."""
    if loop is None:
        loop = asyncio.get_event_loop()
    return loop.create_future()


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> list[tuple[LaunchDescriptionEntity, asyncio.Future[Any]]]:
    """Visit an entity and all entities that it returns. Return pairs of entity and future."""
    following = entity.visit(context)
    future = entity.get_asyncio_future()
    found = [] if future is None else [(entity, future)]
    for following_entity in following or ():
        found += visit_all_entities_and_collect_futures(following_entity, context)
    return found
