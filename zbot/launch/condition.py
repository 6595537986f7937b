"""Conditions: whether an action is to be done."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.errors import ConditionError
from zbot.launch.substitution import describe, normalize, perform, to_bool

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class Condition:
    """Something that holds or not.

    Args:
        predicate: Called with the context.
    """

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds."""
        return self._predicate is None or self._predicate(context)

    def describe(self) -> str:
        """Return one line about it."""
        return f"{type(self).__name__}()"


class AndCondition(Condition):
    """Holds if all of several conditions hold."""

    def __init__(self, conditions: Sequence[Condition]) -> None:
        super().__init__()
        self.conditions = list(conditions)

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds."""
        return all(condition.evaluate(context) for condition in self.conditions)

    def describe(self) -> str:
        """Return one line about it."""
        parts = ", ".join(condition.describe() for condition in self.conditions)
        return f"{type(self).__name__}({parts})"


class OrCondition(AndCondition):
    """Holds if one of several conditions holds."""

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds."""
        return any(condition.evaluate(context) for condition in self.conditions)


class IfCondition(Condition):
    """Holds if a text says true, 1, yes or on."""

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        super().__init__()
        self.expression = normalize(predicate_expression)

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds.

        Raises:
            ConditionError: The text says neither true nor false.
        """
        return evaluate_condition_expression(context, self.expression)

    def describe(self) -> str:
        """Return one line about it."""
        return f"{type(self).__name__}({describe(self.expression)})"


class UnlessCondition(IfCondition):
    """Holds if a text says false, 0, no or off."""

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds; see `IfCondition`."""
        return not super().evaluate(context)


class LaunchConfigurationEquals(Condition):
    """Holds if a launch configuration has a value; with None, if it is not set."""

    def __init__(
        self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None
    ) -> None:
        super().__init__()
        self.name, self.expected = launch_configuration_name, expected_value

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds."""
        value = context.launch_configurations.get(self.name)
        if self.expected is None:
            return value is None
        return value is not None and str(value) == perform(context, self.expected)


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """Holds if a launch configuration does not have a value; with None, if it is set."""

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds."""
        return not super().evaluate(context)


def evaluate_condition_expression(
    context: LaunchContext, expression: SomeSubstitutionsType
) -> bool:
    """Return whether a text says true.

    Raises:
        ConditionError: It says neither true nor false.
    """
    text = perform(context, expression)
    value = to_bool(text)
    if value is None:
        raise ConditionError(text)
    return value
