"""Visits entities and what they lead to."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity


def create_future(loop: asyncio.AbstractEventLoop | None) -> asyncio.Future[Any]:
    """Return a future of a loop; of the present one if None."""
    if loop is None:
        loop = asyncio.get_event_loop_policy().get_event_loop()
    return loop.create_future()


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> list[tuple[LaunchDescriptionEntity, asyncio.Future[Any]]]:
    """Visit an entity and all it leads to; return those with futures, and their futures."""
    following = entity.visit(context)
    future = entity.get_asyncio_future()
    found = [] if future is None else [(entity, future)]
    for one in following or ():
        found += visit_all_entities_and_collect_futures(one, context)
    return found
