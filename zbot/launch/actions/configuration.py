"""Launch configurations and environment variables: set, forgotten, kept for a while."""

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
        """Set it."""
        context.launch_configurations[perform(context, self.name)] = perform(context, self.value)

    def describe(self) -> str:
        """Return name and value."""
        return f"SetLaunchConfiguration({describe(self.name)}, {describe(self.value)})"


class UnsetLaunchConfiguration(Action):
    """Forget a launch configuration; one that is not set is no error."""

    def __init__(self, name: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.name = normalize(name)

    def execute(self, context: LaunchContext) -> None:
        """Forget it."""
        context.launch_configurations.pop(perform(context, self.name), None)


class PushLaunchConfigurations(Action):
    """Remember all launch configurations."""

    def execute(self, context: LaunchContext) -> None:
        """Remember them."""
        context.push("launch_configurations")


class PopLaunchConfigurations(Action):
    """Return to the launch configurations that were remembered last."""

    def execute(self, context: LaunchContext) -> None:
        """Return to them."""
        context.pop("launch_configurations")


class ResetLaunchConfigurations(Action):
    """Forget all launch configurations but those given."""

    def __init__(
        self,
        launch_configurations: Mapping[Any, SomeSubstitutionsType] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.launch_configurations = dict(launch_configurations or {})

    def execute(self, context: LaunchContext) -> None:
        """Forget the others; the values may be made of those that are forgotten."""
        kept = {
            perform(context, name): perform(context, value)
            for name, value in self.launch_configurations.items()
        }
        context.launch_configurations = kept


class SetEnvironmentVariable(Action):
    """Set an environment variable of processes that start from now on."""

    def __init__(
        self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **options: Any
    ) -> None:
        super().__init__(**options)
        self.name, self.value = normalize(name), normalize(value)

    def execute(self, context: LaunchContext) -> None:
        """Set it."""
        context.environment[perform(context, self.name)] = perform(context, self.value)

    def describe(self) -> str:
        """Return name and value."""
        return f"{type(self).__name__}({describe(self.name)}, {describe(self.value)})"


class UnsetEnvironmentVariable(Action):
    """Remove an environment variable; one that is not set is no error."""

    def __init__(self, name: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.name = normalize(name)

    def execute(self, context: LaunchContext) -> None:
        """Remove it."""
        context.environment.pop(perform(context, self.name), None)


class AppendEnvironmentVariable(SetEnvironmentVariable):
    """Add to an environment variable that is a list, such as PATH.

    Args:
        name: Its name.
        value: What to add.
        prepend: Whether to add it at the beginning.
        separator: What stands between the items.
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
        """Add it."""
        name, value = perform(context, self.name), perform(context, self.value)
        present = context.environment.get(name, "")
        if present:
            is_first = perform_typed_substitution(context, self.prepend, bool)
            parts = (value, present) if is_first else (present, value)
            value = perform(context, self.separator).join(parts)
        context.environment[name] = value


class ReplaceEnvironmentVariables(Action):
    """Leave no environment variables but these."""

    def __init__(
        self,
        environment: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.environment = dict(environment or {})

    def execute(self, context: LaunchContext) -> None:
        """Replace them."""
        context.environment = {
            perform(context, name): perform(context, value)
            for name, value in self.environment.items()
        }


class PushEnvironment(Action):
    """Remember the environment."""

    def execute(self, context: LaunchContext) -> None:
        """Remember it."""
        context.push("environment")


class PopEnvironment(Action):
    """Return to the environment that was remembered last."""

    def execute(self, context: LaunchContext) -> None:
        """Return to it."""
        context.pop("environment")


class ResetEnvironment(Action):
    """Return to the environment that the launch itself was started with."""

    def execute(self, context: LaunchContext) -> None:
        """Return to it."""
        context.environment = dict(os.environ)
