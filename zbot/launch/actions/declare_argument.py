"""Actions that declare the arguments of a launch file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.errors import (
    LaunchUsageError,
    missing_argument_error,
    no_choice_error,
    no_default_error,
)
from zbot.launch.substitution import describe, normalize, perform

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class DeclareLaunchArgument(Action):
    """An argument of a launch file, given as `name:=value`.

    Args:
        name: Its name.
        default_value: The value if the argument is not given. None makes the argument required.
        description: The purpose of the argument.
        choices: The valid values. None means that any value is valid.

    Raises:
        LaunchUsageError: The list of choices is empty, or the default is not a choice.
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
        # zbot also accepts a bool or a number as the default. ROS 2's launch fails later with such
        # a default, and its error is unclear.
        is_value = isinstance(default_value, (bool, int, float))
        given = str(default_value) if is_value else default_value
        if self.choices is not None and not self.choices:
            raise LaunchUsageError(f"launch argument '{name}' has no choices: leave `choices` out")
        if self.choices is not None and isinstance(given, str) and given not in self.choices:
            raise no_default_error(name, given, self.choices)
        self.default_value = None if given is None else normalize(given)
        self._description_text = description or ""
        self._conditionally_included = False

    def execute(self, context: LaunchContext) -> None:
        """Set the argument's launch configuration to the default, if no value was given.

        Raises:
            LaunchUsageError: A required argument was not given, or the value is not a choice.
        """
        configurations = context.launch_configurations
        context.declared.add(self.name)
        if self.name not in configurations:
            if self.default_value is None:
                raise missing_argument_error(self.name, self._description_text)
            configurations[self.name] = perform(context, self.default_value)
        value = str(configurations[self.name])
        if self.choices is not None and value not in self.choices:
            raise no_choice_error(self.name, value, self.choices)

    @property
    def conditionally_included(self) -> bool:
        """Whether the declaration depends on a condition. `get_launch_arguments` sets this flag."""
        return self._conditionally_included

    @conditionally_included.setter
    def conditionally_included(self, is_so: bool) -> None:
        self._conditionally_included = is_so

    def describe(self) -> str:
        """Return name, default and description."""
        details = f", default_value={describe(self.default_value)}" if self.default_value else ""
        if self._description_text:
            details += f", description={self._description_text!r}"
        return f"{type(self).__name__}('{self.name}'{details})"


class DeclareBooleanLaunchArgument(DeclareLaunchArgument):
    """An argument that is true or false.

    Args:
        name: Its name.
        options: The options of `DeclareLaunchArgument`, except `choices`.
    """

    def __init__(self, name: str, **options: Any) -> None:
        choices = ["True", "true", "TRUE", "False", "false", "FALSE"]
        super().__init__(name, choices=choices, **options)
