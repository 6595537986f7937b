"""Registry of the tags and substitutions in XML and YAML. Packages may add more of them."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, TypeVar

from zbot.errors.suggestion import question, similar_names
from zbot.launch import substitutions as subs
from zbot.launch.errors import LaunchUsageError, SubstitutionSyntaxError
from zbot.launch.substitution import TextSubstitution

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser
    from zbot.launch.substitution import Substitution

    Builder = Callable[[Entity, Parser], LaunchDescriptionEntity]

Exposed = TypeVar("Exposed", bound="Callable[..., Any]")

ACTIONS: dict[str, Builder] = {}
_EXPOSED: dict[str, Callable[[list[list[Substitution]]], Substitution]] = {}


def action(*names: str) -> Callable[[Builder], Builder]:
    """Register a function that builds the actions for these tags."""

    def register(builder: Builder) -> Builder:
        ACTIONS.update(dict.fromkeys(names, builder))
        return builder

    return register


def expose(
    name: str, exposed_parsers: dict[str, Callable[..., Any]], exposed_type: str
) -> Callable[[Exposed], Exposed]:
    """Register a function, or the `parse` method of a class, in a table of parsers.

    Raises:
        LaunchUsageError: The decorated object is not a function and has no `parse`.
    """

    def register(exposed: Exposed) -> Exposed:
        parse = getattr(exposed, "parse", exposed)
        if not callable(parse):
            text = f"Exposed {exposed_type} parser for {name} is not a callable or a class"
            raise LaunchUsageError(f"{text} containing a parse method")
        exposed_parsers[name] = parse
        return exposed

    return register


def expose_action(name: str) -> Callable[[Exposed], Exposed]:
    """Register a function, or a class with a classmethod `parse`, for a tag.

    The function takes the entity and the parser, and returns a class and its keyword arguments.
    """
    return _registered_in(ACTIONS, name)


def expose_substitution(name: str) -> Callable[[Exposed], Exposed]:
    """Register a function, or a class with a classmethod `parse`, for a substitution.

    The function takes the substitution's arguments, and returns a class and its keyword arguments.
    """
    return _registered_in(_EXPOSED, name)


def _registered_in(builders: dict[str, Any], name: str) -> Callable[[Exposed], Exposed]:
    def register(exposed: Exposed) -> Exposed:
        parse: Callable[..., Any] = getattr(exposed, "parse", exposed)

        def build(*arguments: Any) -> Any:
            made, options = parse(*arguments)
            return made(**options)

        builders[name] = build
        return exposed

    return register


def _joined(arguments: list[list[Substitution]]) -> list[Substitution]:
    """Return arguments joined by blanks."""
    parts: list[Substitution] = []
    for argument in arguments:
        parts += [*([TextSubstitution(text=" ")] if parts else []), *argument]
    return parts


def _with_option(make: Callable[..., Substitution], option: str) -> Callable[..., Substitution]:
    """Return a factory for one or two arguments. `option` is the keyword of the second argument."""
    return lambda first, *second: make(first, **({option: second[0]} if second else {}))


def _optional_environment(name: Any, default: Any = "") -> Substitution:
    return subs.EnvironmentVariable(name, default_value=default)


def _expression(*words: Any) -> Substitution:
    if len(words) == 2:  # as in ROS 2, the second word is a list of modules, separated by commas
        return subs.PythonExpression(words[0], python_modules=words[1])
    return subs.PythonExpression(_joined([*words]))


_configuration = _with_option(subs.LaunchConfiguration, "default")

#: The factory of each substitution, and the minimum and the maximum number of its arguments.
_FACTORIES: dict[str, tuple[Callable[..., Substitution], int, int]] = {
    "var": (_configuration, 1, 2),
    "arg": (_configuration, 1, 2),
    "env": (_with_option(subs.EnvironmentVariable, "default_value"), 1, 2),
    "optenv": (_optional_environment, 1, 2),
    "find-pkg-share": (subs.FindPackageShare, 1, 1),
    "find-pkg-prefix": (subs.FindPackagePrefix, 1, 1),
    "find-pkg": (subs.FindPackage, 1, 1),
    "find-exec": (lambda name: subs.FindExecutable(name=name), 1, 1),
    "exec-in-pkg": (subs.ExecutableInPackage, 2, 2),
    "exec-in-package": (subs.ExecutableInPackage, 2, 2),
    "dirname": (subs.ThisLaunchFileDir, 0, 0),
    "filename": (subs.ThisLaunchFile, 0, 0),
    "launch_log_dir": (subs.LaunchLogDir, 0, 0),
    "log_dir": (subs.LaunchLogDir, 0, 0),
    "eval": (_expression, 1, 999),
    "command": (_with_option(subs.Command, "on_stderr"), 1, 2),
    "not": (subs.NotSubstitution, 1, 1),
    "and": (subs.AndSubstitution, 2, 2),
    "or": (subs.OrSubstitution, 2, 2),
    "all": (subs.AllSubstitution, 1, 999),
    "any": (subs.AnySubstitution, 1, 999),
    "equals": (subs.EqualsSubstitution, 2, 2),
    "not-equals": (subs.NotEqualsSubstitution, 2, 2),
    "is-empty": (subs.IsEmptySubstitution, 1, 1),
    "not-empty": (subs.NotEmptySubstitution, 1, 1),
    "string-strip": (subs.StringStripSubstitution, 1, 1),
    "if": (subs.IfElseSubstitution, 2, 3),
    "file-content": (subs.FileContent, 1, 1),
    "path-join": (lambda *parts: subs.PathJoinSubstitution(parts), 1, 999),
    "str-join": (lambda *parts: subs.StringJoinSubstitution(parts[1:], parts[0]), 1, 999),
    "string-join": (lambda *parts: subs.StringJoinSubstitution(parts[1:], parts[0]), 1, 999),
    "for-var": (_with_option(subs.ForEachVar, "default_value"), 1, 2),
    "index": (subs.ForLoopIndex, 1, 1),
    "param": (_with_option(subs.Parameter, "default"), 1, 2),
    "anon": (subs.AnonName, 1, 1),
    "pathsep": (lambda: TextSubstitution(text=os.pathsep), 0, 0),
}


def make_substitution(name: str, arguments: list[list[Substitution]]) -> Substitution:
    """Return the substitution that has a given name.

    Raises:
        SubstitutionSyntaxError: The name is unknown, or the number of arguments is wrong.
    """
    if name in _EXPOSED:
        return _EXPOSED[name](arguments)
    if name not in _FACTORIES:
        near = similar_names(name, [*_FACTORIES, *_EXPOSED])
        hint = question((f"$({similar} ...)" for similar in near), "; ")
        raise SubstitutionSyntaxError(f"there is no substitution '$({name} ...)'{hint}")
    make, least, largest = _FACTORIES[name]
    if not least <= len(arguments) <= largest:
        count = str(least) if least == largest else f"{least} to {largest}"
        text = f"'$({name} ...)' takes {count} arguments, not {len(arguments)}"
        raise SubstitutionSyntaxError(text)
    return make(*arguments)
