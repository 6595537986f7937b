"""Launch description, the list of entities that a launch file returns."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.entity import LaunchDescriptionEntity, entity_list
from zbot.launch.errors import EntityTypeError, include_loop_error
from zbot.launch.log import get_logger

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from zbot.launch.actions.declare_argument import DeclareLaunchArgument
    from zbot.launch.context import LaunchContext

_INDENT = "    "
_MAX_DEPTH = 60


class LaunchDescription(LaunchDescriptionEntity):
    """List of actions and other descriptions, in the order in which the launch visits them.

    Args:
        initial_entities: Actions and other descriptions.
        deprecated_reason: Why the description is deprecated. The launch logs the text as a warning.
    """

    def __init__(
        self,
        initial_entities: Iterable[LaunchDescriptionEntity] | None = None,
        *,
        deprecated_reason: str | None = None,
    ) -> None:
        self.entities: list[LaunchDescriptionEntity] = []
        self.deprecated_reason = deprecated_reason
        for entity in entity_list("LaunchDescription", initial_entities or ()):
            self.add_entity(entity)

    @property
    def deprecated(self) -> bool:
        """Whether the description is deprecated."""
        return self.deprecated_reason is not None

    def add_entity(self, entity: LaunchDescriptionEntity) -> None:
        """Add an action or another description.

        Raises:
            EntityTypeError: `entity` is not an action or a description.
        """
        if not isinstance(entity, LaunchDescriptionEntity):
            place = f"item {len(self.entities)} of a LaunchDescription"
            raise EntityTypeError(place, "an action", entity)
        self.entities.append(entity)

    add_action = add_entity

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:  # noqa: ARG002
        """Return the entities. Log a warning if the description is deprecated."""
        if self.deprecated_reason is not None:
            get_logger("launch").warning(f"deprecated: {self.deprecated_reason}")
        return self.entities

    def describe(self) -> str:
        """Return the name of the class."""
        return f"{type(self).__name__}()"

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities."""
        return self.entities

    def get_launch_arguments(
        self, conditional_inclusion: bool = False
    ) -> list[DeclareLaunchArgument]:
        """Return the arguments of this description, without the arguments of included files.

        This method sets `conditionally_included` of each argument.
        """
        from zbot.launch.arguments import declared_arguments  # noqa: PLC0415 - cycle

        found = declared_arguments(self, follow_includes=False)
        for argument in found:
            argument.action.conditionally_included = argument.conditional or conditional_inclusion
        return [argument.action for argument in found]


class LaunchIntrospector:
    """Formats launch descriptions without launching them."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return the tree of entities as text, with one entity on each line."""
        return "\n".join(_lines(launch_description, 0))


def _lines(entity: LaunchDescriptionEntity, depth: int) -> Iterator[str]:
    if depth > _MAX_DEPTH:
        raise include_loop_error([entity.describe()])
    is_list = isinstance(entity, LaunchDescription)
    text = "<launch.LaunchDescription>" if is_list else entity.describe()
    condition = getattr(entity, "condition", None)
    condition_text = f" if {condition.describe()}" if condition is not None else ""
    yield f"{_INDENT * depth}{text}{condition_text}"
    for inner in entity.describe_sub_entities():
        yield from _lines(inner, depth + 1)
    for phrase, entities in entity.describe_conditional_sub_entities():
        yield f"{_INDENT * (depth + 1)}{phrase}:"
        for inner in entities:
            yield from _lines(inner, depth + 2)
