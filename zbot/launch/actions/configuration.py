"""Actions that set, remove, save and restore launch configurations and environment variables."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.substitution import describe, normalize, perform
from zbot.launch.typed_value import perform_typed_substitution

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class SetLaunchConfiguration(Action):
    """Set a launch configuration."""

    def __init__(
        self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **options: Any
    ) -> None:
        super().__init__(**options)
        self.name = normalize(name)
        is_value = isinstance(value, (bool, int, float))
        self.value = normalize(str(value) if is_value else value)

    def execute(self, context: LaunchContext) -> None:
        """Set the configuration."""
        context.launch_configurations[perform(context, self.name)] = perform(context, self.value)

    def describe(self) -> str:
        """Return name and value."""
        return f"SetLaunchConfiguration({describe(self.name)}, {describe(self.value)})"


class UnsetLaunchConfiguration(Action):
    """Remove a launch configuration, if it is set."""

    def __init__(self, name: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.name = normalize(name)

    def execute(self, context: LaunchContext) -> None:
        """Remove the configuration."""
        context.launch_configurations.pop(perform(context, self.name), None)


class PushLaunchConfigurations(Action):
    """Save all launch configurations."""

    def execute(self, context: LaunchContext) -> None:
        """Save the configurations."""
        context.push("launch_configurations")


class PopLaunchConfigurations(Action):
    """Restore the launch configurations that were saved last."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the configurations."""
        context.pop("launch_configurations")


class ResetLaunchConfigurations(Action):
    """Replace all launch configurations by the given configurations."""

    def __init__(
        self,
        launch_configurations: Mapping[Any, SomeSubstitutionsType] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.launch_configurations = dict(launch_configurations or {})

    def execute(self, context: LaunchContext) -> None:
        """Replace the configurations. Substitutions in the new values still get the old values."""
        kept = {
            perform(context, name): perform(context, value)
            for name, value in self.launch_configurations.items()
        }
        context.launch_configurations = kept


class SetEnvironmentVariable(Action):
    """Set an environment variable for processes that start later."""

    def __init__(
        self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **options: Any
    ) -> None:
        super().__init__(**options)
        self.name, self.value = normalize(name), normalize(value)

    def execute(self, context: LaunchContext) -> None:
        """Set the variable."""
        context.environment[perform(context, self.name)] = perform(context, self.value)

    def describe(self) -> str:
        """Return name and value."""
        return f"{type(self).__name__}({describe(self.name)}, {describe(self.value)})"


class UnsetEnvironmentVariable(Action):
    """Remove an environment variable, if it is set."""

    def __init__(self, name: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.name = normalize(name)

    def execute(self, context: LaunchContext) -> None:
        """Remove the variable."""
        context.environment.pop(perform(context, self.name), None)


class AppendEnvironmentVariable(SetEnvironmentVariable):
    """Add an item to an environment variable that contains a list, such as PATH.

    Args:
        name: The variable's name.
        value: The item.
        prepend: Whether to add the item at the beginning.
        separator: The text between items.
    """

    def __init__(
        self,
        name: SomeSubstitutionsType,
        value: SomeSubstitutionsType,
        prepend: bool | SomeSubstitutionsType = False,
        separator: SomeSubstitutionsType = os.pathsep,
        **options: Any,
    ) -> None:
        super().__init__(name, value, **options)
        self.prepend: Any = prepend if isinstance(prepend, bool) else normalize(prepend)
        self.separator = normalize(separator)

    def execute(self, context: LaunchContext) -> None:
        """Add the item."""
        name, value = perform(context, self.name), perform(context, self.value)
        present = context.environment.get(name, "")
        if present:
            is_first = perform_typed_substitution(context, self.prepend, bool)
            parts = (value, present) if is_first else (present, value)
            value = perform(context, self.separator).join(parts)
        context.environment[name] = value


class ReplaceEnvironmentVariables(Action):
    """Replace the whole environment."""

    def __init__(
        self,
        environment: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.environment = dict(environment or {})

    def execute(self, context: LaunchContext) -> None:
        """Replace the environment."""
        variables = {
            perform(context, name): perform(context, value)
            for name, value in self.environment.items()
        }
        context.environment.replace(variables)


class PushEnvironment(Action):
    """Save the environment."""

    def execute(self, context: LaunchContext) -> None:
        """Save the environment."""
        context.push("environment")


class PopEnvironment(Action):
    """Restore the environment that was saved last."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the environment."""
        context.pop("environment")


class ResetEnvironment(Action):
    """Restore the environment in which the launch itself was started."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the environment."""
        context.environment.reset()
