"""Conditions, which decide whether an action is executed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.errors import ConditionError
from zbot.launch.substitution import describe, normalize, perform, to_bool

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class Condition:
    """A condition that is true or false during a launch.

    Args:
        predicate: Called with the context. None means that the condition is always true.
    """

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true."""
        return self._predicate is None or self._predicate(context)

    def describe(self) -> str:
        """Return a description in one line."""
        return f"{type(self).__name__}()"


class AndCondition(Condition):
    """Condition that is true if all conditions in it are true."""

    def __init__(self, conditions: Sequence[Condition]) -> None:
        super().__init__()
        self.conditions = list(conditions)

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true."""
        return all(condition.evaluate(context) for condition in self.conditions)

    def describe(self) -> str:
        """Return a description in one line."""
        parts = ", ".join(condition.describe() for condition in self.conditions)
        return f"{type(self).__name__}({parts})"


class OrCondition(AndCondition):
    """Condition that is true if at least one condition in it is true."""

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true."""
        return any(condition.evaluate(context) for condition in self.conditions)


class IfCondition(Condition):
    """Condition that is true if a text is `true`, `1`, `yes` or `on`."""

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        super().__init__()
        self.expression = normalize(predicate_expression)

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true.

        Raises:
            ConditionError: The text is neither true nor false.
        """
        return evaluate_condition_expression(context, self.expression)

    def describe(self) -> str:
        """Return a description in one line."""
        return f"{type(self).__name__}({describe(self.expression)})"


class UnlessCondition(IfCondition):
    """Condition that is true if a text is `false`, `0`, `no` or `off`."""

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true. See `IfCondition`."""
        return not super().evaluate(context)


class LaunchConfigurationEquals(Condition):
    """Condition that a launch configuration has the expected value.

    If the expected value is None, the configuration must not be set.
    """

    def __init__(
        self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None
    ) -> None:
        super().__init__()
        self.name, self.expected = launch_configuration_name, expected_value

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true."""
        value = context.launch_configurations.get(self.name)
        if self.expected is None:
            return value is None
        return value is not None and str(value) == perform(context, self.expected)


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """Condition that a launch configuration does not have the expected value.

    If the expected value is None, the configuration must be set.
    """

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true."""
        return not super().evaluate(context)


def evaluate_condition_expression(
    context: LaunchContext, expression: SomeSubstitutionsType
) -> bool:
    """Return whether a text is `true`, `1`, `yes` or `on`.

    Raises:
        ConditionError: The text is neither true nor false.
    """
    text = perform(context, expression)
    value = to_bool(text)
    if value is None:
        raise ConditionError(text)
    return value
