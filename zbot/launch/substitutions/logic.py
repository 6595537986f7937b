"""Substitutions for logic, comparisons and choices between texts."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.launch.errors import SubstitutionError, argument_count_error
from zbot.launch.substitution import (
    Substitution,
    describe_list,
    is_a_substitution,
    normalize,
    perform,
    to_bool,
)

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from typing_extensions import Self

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class _Operation(Substitution):
    """Base class of substitutions that have texts as operands."""

    def __init__(self, *operands: SomeSubstitutionsType) -> None:
        self.operands = [normalize(operand) for operand in operands]

    def _texts(self, context: LaunchContext) -> list[str]:
        return [perform(context, operand) for operand in self.operands]

    def _truths(self, context: LaunchContext) -> Iterable[bool]:
        for text in self._texts(context):
            value = to_bool(text)
            if value is None:
                raise SubstitutionError(f"{self.describe()} needs true or false, not '{text}'")
            yield value

    def describe(self) -> str:
        """Return the name of the class and the operands."""
        return f"{type(self).__name__}({describe_list(self.operands)[1:-1]})"


class NotSubstitution(_Operation):
    """`true` if the value is false, and `false` if the value is true."""

    def __init__(self, value: SomeSubstitutionsType) -> None:
        super().__init__(value)

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(not next(iter(self._truths(context)))).lower()


class AndSubstitution(_Operation):
    """`true` if both sides are true."""

    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType) -> None:
        super().__init__(left, right)

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(all(list(self._truths(context)))).lower()


class OrSubstitution(AndSubstitution):
    """`true` if at least one side is true."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(any(list(self._truths(context)))).lower()


class AllSubstitution(_Operation):
    """`true` if every operand is true."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(all(list(self._truths(context)))).lower()


class AnySubstitution(_Operation):
    """`true` if at least one operand is true."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(any(list(self._truths(context)))).lower()


class _TextOperation(_Operation):
    """Base class of operations with one operand."""

    def __init__(self, value: SomeSubstitutionsType) -> None:
        super().__init__(value)

    @property
    def value(self) -> list[Substitution]:
        """The operand."""
        return self.operands[0]

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Self], dict[str, Any]]:
        """Return the class and the constructor options for `$(name value)`.

        Raises:
            WrongArgumentsError: The number of arguments is not one.
        """
        if len(data) != 1:
            raise argument_count_error(cls.__name__, 1, len(data))
        return cls, {"value": data[0]}


class IsEmptySubstitution(_TextOperation):
    """`true` if a text is empty. A text of blanks is not empty."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(not self._texts(context)[0]).lower()


class NotEmptySubstitution(_TextOperation):
    """`true` if a text has at least one character, e.g. a blank."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(bool(self._texts(context)[0])).lower()


class StringStripSubstitution(_TextOperation):
    """A text without leading and trailing blanks."""

    def perform(self, context: LaunchContext) -> str:
        """Return the stripped text."""
        return self._texts(context)[0].strip()


def _as_number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


class EqualsSubstitution(_Operation):
    """`true` if both sides are the same text, number or truth value."""

    def __init__(self, left: Any, right: Any) -> None:
        super().__init__(*map(_as_text, (left, right)))

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(self._is_equal(context)).lower()

    def _is_equal(self, context: LaunchContext) -> bool:
        left, right = self._texts(context)
        if left == right:
            return True
        numbers = _as_number(left), _as_number(right)
        if numbers[0] is not None and numbers[1] is not None:
            return math.isclose(numbers[0], numbers[1])
        truths = to_bool(left), to_bool(right)
        return truths[0] is not None and truths[0] == truths[1]


def _as_text(value: Any) -> SomeSubstitutionsType:
    """Return the text of a Python value for a comparison."""
    if value is None:
        return ""
    return value if is_a_substitution(value) else str(value)


class NotEqualsSubstitution(EqualsSubstitution):
    """`true` if the sides differ."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return str(not self._is_equal(context)).lower()


class IfElseSubstitution(Substitution):
    """One text if a condition is true, and another text if it is false."""

    def __init__(
        self,
        condition: SomeSubstitutionsType,
        if_value: SomeSubstitutionsType = "",
        else_value: SomeSubstitutionsType = "",
    ) -> None:
        self.condition = normalize(condition)
        self.if_value, self.else_value = normalize(if_value), normalize(else_value)

    def perform(self, context: LaunchContext) -> str:
        """Return the chosen text.

        Raises:
            SubstitutionError: The condition is neither true nor false.
        """
        text = perform(context, self.condition)
        value = to_bool(text)
        if value is None:
            raise SubstitutionError(f"a condition must be true or false, not '{text}'")
        return perform(context, self.if_value if value else self.else_value)
