"""Action that executes a group of actions with their own configurations and environment."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.actions.configuration import (
    PopEnvironment,
    PopLaunchConfigurations,
    PushEnvironment,
    PushLaunchConfigurations,
    ResetEnvironment,
    ResetLaunchConfigurations,
    SetLaunchConfiguration,
)
from zbot.launch.entity import entity_list

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.substitution import SomeSubstitutionsType


class GroupAction(Action):
    """Execute a group of actions under one condition and in one scope.

    Args:
        actions: The actions.
        scoped: Whether configurations, namespaces and environment are restored after the actions.
        forwarding: Whether actions of a scoped group get the configurations and the environment
            that are set outside of the group.
        launch_configurations: Configurations to set for the actions.
    """

    def __init__(
        self,
        actions: Iterable[LaunchDescriptionEntity],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: Mapping[Any, SomeSubstitutionsType] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.actions = entity_list("GroupAction", actions)
        self.scoped, self.forwarding = scoped, forwarding
        self.launch_configurations = dict(launch_configurations or {})

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the actions. For a scoped group, add actions that open and close the scope."""
        sets: list[LaunchDescriptionEntity] = [
            SetLaunchConfiguration(name, value)
            for name, value in self.launch_configurations.items()
        ]
        if not self.scoped:
            return [*sets, *self.actions]
        if not self.forwarding:
            sets = [ResetEnvironment(), ResetLaunchConfigurations(self.launch_configurations)]
        opening: list[LaunchDescriptionEntity] = [PushLaunchConfigurations(), PushEnvironment()]
        closing: list[LaunchDescriptionEntity] = [PopEnvironment(), PopLaunchConfigurations()]
        return [*opening, *sets, *self.actions, *closing]

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:
        """Return the actions. For a scoped group, add actions that open and close the scope."""
        del context
        return self.get_sub_entities()

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Sequence[LaunchDescriptionEntity]]]:
        """Return the actions if the group has a condition."""
        return [] if self.condition is None else [("group condition", self.actions)]

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the actions if the group has no condition."""
        return self.actions if self.condition is None else []
