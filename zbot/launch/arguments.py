"""The arguments that a launch description declares, and those on a command line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.launch.errors import LaunchArgumentError

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from zbot.launch.actions.declare_argument import DeclareLaunchArgument
    from zbot.launch.entity import LaunchDescriptionEntity


@dataclass(frozen=True)
class DeclaredArgument:
    """An argument, and whether it is declared only under a condition."""

    action: DeclareLaunchArgument
    conditional: bool


def declared_arguments(
    entity: LaunchDescriptionEntity, *, follow_includes: bool = True
) -> list[DeclaredArgument]:
    """Return the arguments of a description and of what it includes, each name once.

    Included files whose path is not known before the launch are left out, as are arguments that an
    include sets.
    """
    found: dict[str, DeclaredArgument] = {}
    for one in _walk(entity, frozenset(), set(), conditional=False, follow=follow_includes):
        present = found.get(one.action.name)
        if present is None or (present.conditional and not one.conditional):
            found[one.action.name] = one
    return list(found.values())


def _walk(
    entity: LaunchDescriptionEntity,
    given: frozenset[str],
    seen: set[str],
    *,
    conditional: bool,
    follow: bool,
) -> Iterator[DeclaredArgument]:
    from zbot.launch.actions.declare_argument import DeclareLaunchArgument  # noqa: PLC0415 - cycle
    from zbot.launch.actions.include import IncludeLaunchDescription  # noqa: PLC0415 - cycle

    conditional = conditional or getattr(entity, "condition", None) is not None
    if isinstance(entity, DeclareLaunchArgument):
        if entity.name not in given:
            yield DeclaredArgument(entity, conditional)
        return
    if isinstance(entity, IncludeLaunchDescription):
        if follow:
            yield from _walk_include(entity, given, seen, conditional=conditional)
        return
    for one in entity.describe_sub_entities():
        yield from _walk(one, given, seen, conditional=conditional, follow=follow)
    for _, entities in entity.describe_conditional_sub_entities():
        for one in entities:
            yield from _walk(one, given, seen, conditional=True, follow=follow)


def _walk_include(
    entity: object, given: frozenset[str], seen: set[str], *, conditional: bool
) -> Iterator[DeclaredArgument]:
    from zbot.launch.actions.include import IncludeLaunchDescription  # noqa: PLC0415 - cycle

    assert isinstance(entity, IncludeLaunchDescription)
    source = entity.launch_description_source
    description = source.try_get_launch_description_without_context()
    if description is None or source.location_text in seen:
        return
    seen.add(source.location_text)
    names = {name for name, _ in entity.launch_arguments if isinstance(name, str)}
    yield from _walk(description, given | names, seen, conditional=conditional, follow=True)


def parse_arguments(words: Sequence[str]) -> dict[str, str]:
    """Return the values of `name:=value` words; of several with one name the last.

    Raises:
        LaunchArgumentError: A word has another form.
    """
    values: dict[str, str] = {}
    for word in words:
        name, assign, value = word.partition(":=")
        if not assign or not name or not value:
            raise LaunchArgumentError.malformed(word)
        values[name] = value
    return values
