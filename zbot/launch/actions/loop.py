"""Loop actions, which create actions once for each value of a list."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.actions.opaque import OpaqueFunction
from zbot.launch.errors import LaunchUsageError
from zbot.launch.substitution import describe, normalize, perform
from zbot.launch.substitutions.value import ForEachVar
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.substitution import SomeSubstitutionsType

    Entities = Sequence[LaunchDescriptionEntity] | None

SEPARATOR = ";"


def loop_iteration(
    values: Mapping[str, Any], entities: Iterable[LaunchDescriptionEntity]
) -> list[LaunchDescriptionEntity]:
    """Return the entities of one iteration, and actions that set and remove its locals."""
    seen = {ForEachVar.get_local_arg_name(key): value for key, value in values.items()}
    # Three functions do this, as in ROS 2's launch, because launch's tests compare each entity.
    opened = [OpaqueFunction(function=_open), OpaqueFunction(function=_fill, args=(seen,))]
    return [*opened, *entities, OpaqueFunction(function=_close)]


def _open(context: LaunchContext) -> None:
    context.extend_locals({})


def _fill(context: LaunchContext, values: Mapping[str, Any]) -> None:
    context.extend_locals(values)


def _close(context: LaunchContext) -> None:
    context.pop_locals()
    context.pop_locals()


class ForEach(Action):
    """Call a function with each dictionary of a list, and execute the returned entities.

    Args:
        input_values: YAML dictionaries, separated by semicolons: `{name: a, id: 1};{name: b}`.
        function: Called with the values of one dictionary as keyword arguments.
    """

    def __init__(
        self,
        input_values: SomeSubstitutionsType,
        *,
        function: Callable[..., Entities],
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.input_values, self.function = normalize(input_values), function

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return the entities for all dictionaries, in the order of the dictionaries.

        Raises:
            LaunchUsageError: A part is not a dictionary.
        """
        text = perform(context, self.input_values)
        parts = [part for part in text.split(SEPARATOR) if part.strip()]
        return [each for part in parts for each in self.function(**_values(part)) or ()]

    def describe(self) -> str:
        """Return the input values."""
        return f"ForEach({describe(self.input_values)})"


class ForLoop(Action):
    """Call a function with each number from 0 to `length` - 1, and execute the returned entities.

    Args:
        length: The number of iterations.
        function: Called with the number as `i`.
        name: The name of the loop.
    """

    def __init__(
        self,
        length: SomeSubstitutionsType,
        *,
        function: Callable[..., Entities],
        name: str | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.length, self.function, self.name = normalize(length), function, name

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return a `ForEach` action for the numbers.

        Raises:
            LaunchUsageError: The length is not a whole number.
        """
        text = perform(context, self.length)
        try:
            length = int(text)
        except ValueError:
            raise LaunchUsageError(f"a ForLoop needs a whole number, not '{text}'") from None
        numbers = SEPARATOR.join(f"{{i: {number}}}" for number in range(length))
        return [ForEach(numbers, function=self.function)]

    def describe(self) -> str:
        """Return the number of iterations."""
        return f"ForLoop({describe(self.length)})"


def _values(text: str) -> dict[str, Any]:
    try:
        values = read_yaml(text)
    except YamlError:
        values = None
    if not isinstance(values, dict):
        shown = " ".join(text.split())
        raise LaunchUsageError(f"a ForEach needs dictionaries like {{name: a}}, not '{shown}'")
    return values
