"""Action that includes another launch file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.actions.configuration import SetLaunchConfiguration
from zbot.launch.arguments import declared_arguments
from zbot.launch.description import LaunchDescription
from zbot.launch.errors import (
    EntityTypeError,
    LaunchFileError,
    include_loop_error,
    missing_argument_error,
    missing_in_include_error,
)
from zbot.launch.source import LaunchDescriptionSource, file_locals
from zbot.launch.substitution import is_a_substitution, normalize, perform
from zbot.package.absent import absent_file

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.substitution import SomeSubstitutionsType

_MAX_DEPTH = 60


class _RestoreFileLocals(Action):
    """Make `ThisLaunchFile` and similar substitutions refer to the including file again."""

    def execute(self, context: LaunchContext) -> None:
        context.pop_locals()


class IncludeLaunchDescription(Action):
    """Launch the description of another file.

    Args:
        launch_description_source: A source, a description or a path.
        launch_arguments: Pairs of argument name and value.
    """

    def __init__(
        self,
        launch_description_source: LaunchDescriptionSource | SomeSubstitutionsType,
        *,
        launch_arguments: Mapping[Any, Any] | Iterable[tuple[Any, Any]] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        source: Any = launch_description_source
        if isinstance(source, LaunchDescription):
            source = LaunchDescriptionSource(source)
        if is_a_substitution(source):
            source = LaunchDescriptionSource(location=source)
        if not isinstance(source, LaunchDescriptionSource):
            raise EntityTypeError("launch_description_source", "a source or a path", source)
        self.launch_description_source = source
        given: Any = launch_arguments or ()
        # ROS 2's examples use the `.items()` of a dictionary. The dictionary itself works too.
        pairs = given.items() if hasattr(given, "items") else given
        self.launch_arguments: list[tuple[Any, Any]] = list(pairs)

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:
        """Return the actions that set the file's arguments, and the file's entities.

        While the launch visits the file's entities, `ThisLaunchFile` and similar substitutions
        refer to the file.

        Raises:
            AbsentFileError: The file is in a well-known package that does not run in zbot.
            LaunchError: The file includes itself without end.
            LaunchUsageError: The include does not give a required argument of the file.
            LaunchFileError: A required argument is missing, and this include is not in a launch
                file. The error shows the line that declares the argument.
        """
        path = self.launch_description_source.path(context)
        absent = absent_file(path) if path is not None else None
        if absent is not None:
            raise absent
        description = self.launch_description_source.get_launch_description(context)
        sets: list[LaunchDescriptionEntity] = []
        given = {}
        for name, value in self.launch_arguments:
            key = perform(context, normalize(name))
            given[key] = perform(context, _text(value))
            sets.append(SetLaunchConfiguration(key, given[key]))
        self._check(context, description, given)
        if path is None:
            return [*sets, description]
        extensions = {
            **file_locals(path),
            "include_chain": self._chain(context, str(path), given),
        }
        context.extend_locals(extensions)
        return [*sets, description, _RestoreFileLocals()]

    def _chain(
        self, context: LaunchContext, path: str, given: Mapping[str, str]
    ) -> tuple[tuple[str, str], ...]:
        # A file may include itself with other arguments, because such a recursion can end.
        state = {**context.launch_configurations, **given}
        link = (path, repr(sorted((key, str(value)) for key, value in state.items())))
        chain: tuple[tuple[str, str], ...] = context.get_locals_as_dict().get("include_chain", ())
        if link in chain or len(chain) >= _MAX_DEPTH:
            start = chain.index(link) if link in chain else max(0, len(chain) - 3)
            raise include_loop_error([file for file, _ in (*chain[start:], link)])
        return (*chain, link)

    def _check(
        self, context: LaunchContext, description: LaunchDescription, given: Mapping[str, str]
    ) -> None:
        # As in ROS 2's launch, this check runs before the first action of the file. The check
        # ignores arguments of the including file that have the same name.
        declared = declared_arguments(description, follow_includes=False)
        context.declared.update(found.action.name for found in declared)
        for found in declared:
            action = found.action
            if action.default_value is None and not found.conditional and action.name not in given:
                if self.origin is not None:
                    raise missing_in_include_error(action.name, given)
                is_described = action.description != "no description given"
                described = action.description if is_described else ""
                error = missing_argument_error(action.name, described)
                raise error if action.origin is None else LaunchFileError.at(action.origin, error)

    def describe(self) -> str:
        """Return the source."""
        return f"IncludeLaunchDescription({self.launch_description_source.location_text})"


def _text(value: Any) -> Any:
    return str(value) if isinstance(value, (bool, int, float)) else normalize(value)
