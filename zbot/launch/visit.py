"""Visitor of an entity and of all entities that follow from it."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity


def create_future(loop: asyncio.AbstractEventLoop | None) -> asyncio.Future[Any]:
    """Return a new future of an event loop. None means the loop of this thread."""
    if loop is None:
        loop = asyncio.get_event_loop_policy().get_event_loop()
    return loop.create_future()


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> list[tuple[LaunchDescriptionEntity, asyncio.Future[Any]]]:
    """Visit an entity and all entities that it returns. Return pairs of entity and future."""
    following = entity.visit(context)
    future = entity.get_asyncio_future()
    found = [] if future is None else [(entity, future)]
    for one in following or ():
        found += visit_all_entities_and_collect_futures(one, context)
    return found
