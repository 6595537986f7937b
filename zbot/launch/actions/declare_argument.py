"""Arguments of a launch file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.errors import LaunchArgumentError
from zbot.launch.substitution import describe, normalize, perform

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class DeclareLaunchArgument(Action):
    """An argument that may be given as `name:=value`.

    Args:
        name: Its name.
        default_value: The value where it is not given; without one it has to be.
        description: What it is for.
        choices: The only values it may have; any if left out.

    Raises:
        LaunchArgumentError: There are no choices, or the default is none of them.
    """

    def __init__(
        self,
        name: str,
        *,
        default_value: SomeSubstitutionsType | None = None,
        description: str | None = None,
        choices: Iterable[str] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.name = name
        self.description = description or "no description given"
        self.choices = None if choices is None else list(choices)
        # launch fails later, and less clearly, for a bool or a number
        is_value = isinstance(default_value, (bool, int, float))
        given = str(default_value) if is_value else default_value
        if self.choices is not None and not self.choices:
            raise LaunchArgumentError(f"launch argument '{name}' has no choices: leave them out")
        if self.choices is not None and isinstance(given, str) and given not in self.choices:
            raise LaunchArgumentError.no_default(name, given, self.choices)
        self.default_value = None if given is None else normalize(given)
        self._told = description or ""
        self._conditionally_included = False

    def execute(self, context: LaunchContext) -> None:
        """Set its configuration to the default if it was not given.

        Raises:
            LaunchArgumentError: It was not given and has no default, or is none of the choices.
        """
        configurations = context.launch_configurations
        if self.name not in configurations:
            if self.default_value is None:
                raise LaunchArgumentError.missing(self.name, self._told)
            configurations[self.name] = perform(context, self.default_value)
        value = str(configurations[self.name])
        if self.choices is not None and value not in self.choices:
            raise LaunchArgumentError.no_choice(self.name, value, self.choices)

    @property
    def conditionally_included(self) -> bool:
        """Whether its declaration depends on a condition; a description finds out."""
        return self._conditionally_included

    @conditionally_included.setter
    def conditionally_included(self, is_so: bool) -> None:
        self._conditionally_included = is_so

    def describe(self) -> str:
        """Return its name."""
        told = f", default_value={describe(self.default_value)}" if self.default_value else ""
        if self._told:
            told += f", description={self._told!r}"
        return f"{type(self).__name__}('{self.name}'{told})"


class DeclareBooleanLaunchArgument(DeclareLaunchArgument):
    """An argument that is true or false.

    Args:
        name: Its name.
        options: As for `DeclareLaunchArgument`, without `choices`.
    """

    def __init__(self, name: str, **options: Any) -> None:
        choices = ["True", "true", "TRUE", "False", "false", "FALSE"]
        super().__init__(name, choices=choices, **options)
