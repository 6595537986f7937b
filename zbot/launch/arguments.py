"""Arguments of launch descriptions, and their values on a command line."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.launch.errors import malformed_argument_error
from zbot.launch.substitution import describe

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from zbot.launch.actions.declare_argument import DeclareLaunchArgument
    from zbot.launch.actions.include import IncludeLaunchDescription
    from zbot.launch.entity import LaunchDescriptionEntity


@dataclass(frozen=True)
class DeclaredArgument:
    """A declared argument. It is `conditional` if its declaration depends on a condition."""

    action: DeclareLaunchArgument
    conditional: bool


def declared_arguments(
    entity: LaunchDescriptionEntity,
    *,
    path: str = "",
    follow_includes: bool = True,
    report: Callable[[IncludeLaunchDescription, ZbotError], object] = lambda *_: None,
) -> list[DeclaredArgument]:
    """Return the arguments of a description and of its included files. Each name occurs once.

    The result leaves out an argument if an include sets its value. The result also leaves out the
    arguments of an included file whose path is known only during the launch, and those of a file
    that cannot be read before the launch. The launch may leave such a file out, or set what the
    file needs.

    Args:
        entity: The description.
        path: The file of the description, if there is one.
        follow_includes: Whether to read included files.
        report: Function that gets each include whose file cannot be read, and the error.
    """
    found: dict[str, DeclaredArgument] = {}
    for argument in _walk(entity, _Position(path=path, follows=follow_includes, report=report)):
        present = found.get(argument.action.name)
        if present is None or (present.conditional and not argument.conditional):
            found[argument.action.name] = argument
    return list(found.values())


@dataclass(frozen=True)
class _Position:
    """Position of an entity in a tree of launch files."""

    path: str = ""  #: path of the launch file that contains the entity
    given: frozenset[str] = frozenset()  #: names of arguments that an include sets
    chain: tuple[str, ...] = ()  #: paths of included files, from the outermost to this file
    conditional: bool = False
    follows: bool = True  #: whether included files are read
    report: Callable[[IncludeLaunchDescription, ZbotError], object] = lambda *_: None


def _walk(entity: LaunchDescriptionEntity, place: _Position) -> Iterator[DeclaredArgument]:
    from zbot.launch.actions.declare_argument import DeclareLaunchArgument  # noqa: PLC0415 - cycle
    from zbot.launch.actions.include import IncludeLaunchDescription  # noqa: PLC0415 - cycle

    if getattr(entity, "condition", None) is not None:
        place = replace(place, conditional=True)
    if isinstance(entity, DeclareLaunchArgument):
        if entity.name not in place.given:
            yield DeclaredArgument(entity, place.conditional)
    elif isinstance(entity, IncludeLaunchDescription):
        if place.follows:
            yield from _walk_include(entity, place)
    else:
        for inner in entity.describe_sub_entities():
            yield from _walk(inner, place)
        for _, entities in entity.describe_conditional_sub_entities():
            for inner in entities:
                yield from _walk(inner, replace(place, conditional=True))


def _walk_include(entity: IncludeLaunchDescription, place: _Position) -> Iterator[DeclaredArgument]:
    source = entity.launch_description_source
    path = source.location_before_launch(place.path) or ""
    # Skip missing files and endless includes. The launch itself reports them.
    if path in place.chain or (path and not Path(path).is_file()):
        return
    try:
        description = source.try_get_launch_description_without_context(place.path)
    except ZbotError as error:
        place.report(entity, error)
        return
    if description is not None:
        names = {describe(name).strip("'") for name, _ in entity.launch_arguments}
        chain, given = (*place.chain, path), place.given | names
        yield from _walk(description, replace(place, path=path, given=given, chain=chain))


def parse_arguments(words: Sequence[str]) -> dict[str, str]:
    """Return the values of `name:=value` words. If a name occurs twice, the last value is used.

    Raises:
        LaunchUsageError: A word does not have this form.
    """
    values: dict[str, str] = {}
    for word in words:
        name, assign, value = word.partition(":=")
        if not assign or not name or not value:
            raise malformed_argument_error(word)
        values[name] = value
    return values
