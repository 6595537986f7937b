"""Tags of `launch`, such as arguments, groups, includes, environment, programs and timers."""

from __future__ import annotations

import os
import warnings
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from zbot.launch import actions
from zbot.launch.actions.loop import loop_iteration
from zbot.launch.errors import SubstitutionSyntaxError
from zbot.launch.frontend.registry import action, expose_action
from zbot.launch.source import AnyLaunchDescriptionSource
from zbot.launch.substitution import TextSubstitution

if TYPE_CHECKING:
    from zbot.launch.action import Action
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser
    from zbot.launch.substitution import Substitution

_QUOTES = "\"'"


def text(entity: Entity, parser: Parser, name: str) -> list[Substitution] | None:
    """Return an attribute as substitutions, or None if it is missing."""
    value = entity.text(name)
    return None if value is None else parser.parse_substitution(value)


def required_text(entity: Entity, parser: Parser, name: str) -> list[Substitution]:
    """Return a required attribute as substitutions."""
    return parser.parse_substitution(entity.required(name))


def boolean(entity: Entity, name: str, *, default: bool) -> bool:
    """Return an attribute that is true or false. Return `default` if the attribute is missing."""
    found: bool | None = entity.get_attr(name, data_type=bool, optional=True, can_be_str=False)
    return default if found is None else found


def words(parts: list[Substitution], *, keeps_quotes: bool = False) -> list[list[Substitution]]:
    """Return the words of a command line. Each word is a list of substitutions.

    Blanks end a word, but not between quotes or in the text of a substitution.

    Args:
        parts: The command line.
        keeps_quotes: Whether quotes stay in the words. A shell needs these quotes.
    """
    found: list[list[Substitution]] = [[]]
    quote, is_open = "", False
    for part in parts:
        if not isinstance(part, TextSubstitution):
            found[-1].append(part)
            is_open = True
            continue
        for character in part.text:
            if character == quote or (not quote and character in _QUOTES):
                quote, is_open = "" if quote else character, True
                found[-1] += [TextSubstitution(text=character)] if keeps_quotes else []
            elif character.isspace() and not quote:
                found += [[]] if is_open else []
                is_open = False
            else:
                found[-1].append(TextSubstitution(text=character))
                is_open = True
    if quote:
        raise SubstitutionSyntaxError(f"the quote {quote} is not closed")
    return [_merged(word) for word in (found if is_open else found[:-1])]


def _merged(parts: list[Substitution]) -> list[Substitution]:
    """Return a word in which adjacent texts are joined."""
    merged: list[Substitution] = []
    texts: list[str] = []
    for part in parts:
        if isinstance(part, TextSubstitution):
            texts.append(part.text)
            continue
        if texts:
            merged.append(TextSubstitution(text="".join(texts)))
            texts = []
        merged.append(part)
    return [*merged, TextSubstitution(text="".join(texts))] if texts else merged


def process_options(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return the constructor options that all process actions share."""
    options: dict[str, Any] = {}
    names = {
        "launch-prefix": "prefix",
        "cwd": "cwd",
        "output": "output",
        "respawn": "respawn",
        "respawn_delay": "respawn_delay",
        "sigterm_timeout": "sigterm_timeout",
        "sigkill_timeout": "sigkill_timeout",
        "on_exit": "on_exit",
        "respawn_max_retries": "respawn_max_retries",
    }
    for attribute, option in names.items():
        value = text(entity, parser, attribute)
        if value is not None:
            options[option] = value
    is_terminal = entity.get_attr("emulate_tty", data_type=bool, optional=True)
    if is_terminal is not None:
        options["emulate_tty"] = parser.parse_if_substitutions(is_terminal)
    if "on_exit" in options:
        options["on_exit"] = entity.text("on_exit")
        if options["on_exit"] != "shutdown":
            raise entity.error(f"'on_exit' can only be 'shutdown', not '{options['on_exit']}'")
    if "respawn_max_retries" in options:
        options["respawn_max_retries"] = entity.get_attr("respawn_max_retries", data_type=int)
    environment = _named_values(entity, parser, "env")
    return {**options, **({"additional_env": environment} if environment else {})}


def _named_values(entity: Entity, parser: Parser, tag: str) -> dict[Any, list[Substitution]]:
    return {
        required_text(child, parser, "name")[0]: required_text(child, parser, "value")
        for child in entity.children_of_type(tag)
    }


def add_plain_tags(tags: dict[str, tuple[Any, ...]]) -> None:
    """Register tags whose attributes are all required.

    Args:
        tags: The class of each tag's action, and the attributes with the arguments of this class.
    """
    for tag, (kind, *attributes) in tags.items():
        action(tag)(partial(_plain_action, kind, attributes))


def _plain_action(kind: Any, attributes: list[str], entity: Entity, parser: Parser) -> Action:
    made: Action = kind(*(required_text(entity, parser, name) for name in attributes))
    return made


add_plain_tags(
    {
        "let": (actions.SetLaunchConfiguration, "name", "value"),
        "unset_let": (actions.UnsetLaunchConfiguration, "name"),
        "unset_launch_configuration": (actions.UnsetLaunchConfiguration, "name"),
        "set_env": (actions.SetEnvironmentVariable, "name", "value"),
        "unset_env": (actions.UnsetEnvironmentVariable, "name"),
        "push_env": (actions.PushEnvironment,),
        "pop_env": (actions.PopEnvironment,),
        "reset_env": (actions.ResetEnvironment,),
    }
)


@action("arg")
def _argument(entity: Entity, parser: Parser) -> Action:
    choices = [choice.required("value") for choice in entity.children_of_type("choice")]
    return actions.DeclareLaunchArgument(
        entity.required("name"),
        default_value=text(entity, parser, "default"),
        description=entity.text("description"),
        choices=choices or None,
    )


@action("include")
def _include(entity: Entity, parser: Parser) -> Action:
    pairs = [
        (required_text(child, parser, "name"), required_text(child, parser, "value"))
        for child in (*entity.children_of_type("arg"), *entity.children_of_type("let"))
    ]
    source = AnyLaunchDescriptionSource(required_text(entity, parser, "file"))
    return actions.IncludeLaunchDescription(source, launch_arguments=pairs)


@action("group")
def _group(entity: Entity, parser: Parser) -> Action:
    inside = [child for child in entity.children if child.type_name != "keep"]
    return actions.GroupAction(
        [parser.parse_action(child) for child in inside],
        scoped=boolean(entity, "scoped", default=True),
        forwarding=boolean(entity, "forwarding", default=True),
        launch_configurations=_named_values(entity, parser, "keep"),
    )


@action("for")
def _for(entity: Entity, parser: Parser) -> Action:
    name = entity.required("name")
    parser.actions(entity)  # reports errors inside a loop, even if the loop has no iterations

    def one_iteration(i: int) -> list[LaunchDescriptionEntity]:
        return loop_iteration({name: i}, parser.actions(entity))

    return actions.ForLoop(required_text(entity, parser, "len"), function=one_iteration, name=name)


@action("for_each")
def _for_each(entity: Entity, parser: Parser) -> Action:
    parser.actions(entity)  # reports errors, even if the loop has no iterations

    def one_iteration(**values: Any) -> list[LaunchDescriptionEntity]:
        return loop_iteration(values, parser.actions(entity))

    return actions.ForEach(required_text(entity, parser, "values"), function=one_iteration)


@action("append_env")
def _append_env(entity: Entity, parser: Parser) -> Action:
    return actions.AppendEnvironmentVariable(
        required_text(entity, parser, "name"),
        required_text(entity, parser, "value"),
        prepend=boolean(entity, "prepend", default=False),
        separator=text(entity, parser, "separator") or os.pathsep,
    )


@action("rep_env")
def _replace_env(entity: Entity, parser: Parser) -> Action:
    return actions.ReplaceEnvironmentVariables(_named_values(entity, parser, "env"))


@action("reset")
def _reset(entity: Entity, parser: Parser) -> Action:
    return actions.ResetLaunchConfigurations(_named_values(entity, parser, "keep"))


@action("log")
def _log(entity: Entity, parser: Parser) -> Action:
    level = text(entity, parser, "level")
    if level is None:
        message = "`log` without a level means INFO; ROS 2 will require a level: write `log_info`"
        warnings.warn(message, DeprecationWarning, stacklevel=2)
        level = [TextSubstitution(text="INFO")]
    return actions.Log(msg=required_text(entity, parser, "message"), level=level)


_LOG_ACTIONS: Final[dict[str, type[actions.LogInfo]]] = {
    "debug": actions.LogDebug,
    "info": actions.LogInfo,
    "warning": actions.LogWarning,
    "error": actions.LogError,
}


@action("log_debug", "log_info", "log_warning", "log_error")
def _log_of_level(entity: Entity, parser: Parser) -> Action:
    level = entity.type_name.replace("-", "_").removeprefix("log_")
    return _LOG_ACTIONS[level](msg=required_text(entity, parser, "message"))


@action("timer")
def _timer(entity: Entity, parser: Parser) -> Action:
    period = parser.parse_if_substitutions(entity.get_attr("period", data_type=float))
    return actions.TimerAction(period=period, actions=parser.actions(entity))


@action("shutdown")
def _shutdown(entity: Entity, parser: Parser) -> Action:
    return actions.Shutdown(reason=text(entity, parser, "reason") or "reason not given")


def executable_options(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return the constructor options of `ExecuteProcess` for an `executable` tag."""
    shell = boolean(entity, "shell", default=False)
    command = required_text(entity, parser, "cmd")
    arguments = text(entity, parser, "args")
    if arguments is not None:
        command = [*command, TextSubstitution(text=" "), *arguments]
    return {
        "cmd": words(command, keeps_quotes=shell),
        "shell": shell,
        "name": text(entity, parser, "name"),
        **process_options(entity, parser),
    }


expose_action("executable")(actions.ExecuteProcess)
