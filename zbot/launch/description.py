"""Launch description, the list of entities that a launch file returns."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.entity import LaunchDescriptionEntity
from zbot.launch.errors import EntityTypeError
from zbot.launch.log import get_logger

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.launch.actions.declare_argument import DeclareLaunchArgument
    from zbot.launch.context import LaunchContext


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
        if isinstance(initial_entities, LaunchDescriptionEntity):
            raise EntityTypeError("LaunchDescription", "given a list, [...]", initial_entities)
        for entity in initial_entities or ():
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
        for one in found:
            one.action.conditionally_included = one.conditional or conditional_inclusion
        return [one.action for one in found]
