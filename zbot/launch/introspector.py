"""Formatter of launch descriptions as readable text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.description import LaunchDescription
from zbot.launch.errors import include_loop_error

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.launch.entity import LaunchDescriptionEntity

_INDENT = "    "
_MAX_DEPTH = 60


class LaunchIntrospector:
    """Formats launch descriptions without launching them."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return the tree of entities as text, with one entity on each line."""
        return "\n".join(_lines(launch_description, 0))

    def get_source(self, entity: LaunchDescriptionEntity) -> str:
        """Return the file and the line that created an entity, or `unknown`."""
        origin = getattr(entity, "origin", None)
        return f"{origin.path}:{origin.line}" if origin is not None else "unknown"


def _lines(entity: LaunchDescriptionEntity, depth: int) -> Iterator[str]:
    if depth > _MAX_DEPTH:
        raise include_loop_error([entity.describe()])
    is_list = isinstance(entity, LaunchDescription)
    text = "<launch.LaunchDescription>" if is_list else entity.describe()
    condition = getattr(entity, "condition", None)
    condition_text = f" if {condition.describe()}" if condition is not None else ""
    yield f"{_INDENT * depth}{text}{condition_text}"
    for one in entity.describe_sub_entities():
        yield from _lines(one, depth + 1)
    for phrase, entities in entity.describe_conditional_sub_entities():
        yield f"{_INDENT * (depth + 1)}{phrase}:"
        for one in entities:
            yield from _lines(one, depth + 2)
