"""The tags of `launch`: arguments, groups, includes, environment, programs, timers."""

from __future__ import annotations

import os
import warnings
from typing import TYPE_CHECKING, Any, Final

from zbot.launch import actions
from zbot.launch.actions.loop import in_a_round
from zbot.launch.frontend.errors import SubstitutionSyntaxError
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
    """Return an attribute with its substitutions; None if there is none."""
    value = entity.text(name)
    return None if value is None else parser.parse_substitution(value)


def needed(entity: Entity, parser: Parser, name: str) -> list[Substitution]:
    """Return an attribute with its substitutions, which has to be there."""
    return parser.parse_substitution(entity.required(name))


def truth(entity: Entity, name: str, *, default: bool) -> bool:
    """Return an attribute that says true or false."""
    found: bool | None = entity.get_attr(name, data_type=bool, optional=True, can_be_str=False)
    return default if found is None else found


def words(parts: list[Substitution], *, keeps_quotes: bool = False) -> list[list[Substitution]]:
    """Return the words of a command line, of which each is made of substitutions.

    Blanks end a word, except between quotes or inside of what a substitution becomes.

    Args:
        parts: The command line.
        keeps_quotes: Whether quotes stay in the words, for a shell to read.
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
    """Return a word with neighbouring texts as one."""
    merged: list[Substitution] = []
    for part in parts:
        last = merged[-1] if merged else None
        if isinstance(part, TextSubstitution) and isinstance(last, TextSubstitution):
            merged[-1] = TextSubstitution(text=last.text + part.text)
        else:
            merged.append(part)
    return merged


def process_options(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return what every process may be given."""
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
    environment = _environment(entity, parser)
    return {**options, **({"additional_env": environment} if environment else {})}


def _environment(entity: Entity, parser: Parser) -> dict[Any, list[Substitution]]:
    return {
        parser.parse_substitution(one.required("name"))[0]: needed(one, parser, "value")
        for one in entity.inside("env")
    }


@action("arg")
def _argument(entity: Entity, parser: Parser) -> Action:
    choices = [choice.required("value") for choice in entity.inside("choice")]
    return actions.DeclareLaunchArgument(
        entity.required("name"),
        default_value=text(entity, parser, "default"),
        description=entity.text("description"),
        choices=choices or None,
    )


@action("let")
def _let(entity: Entity, parser: Parser) -> Action:
    return actions.SetLaunchConfiguration(
        needed(entity, parser, "name"), needed(entity, parser, "value")
    )


@action("include")
def _include(entity: Entity, parser: Parser) -> Action:
    pairs = [
        (needed(one, parser, "name"), needed(one, parser, "value"))
        for one in (*entity.inside("arg"), *entity.inside("let"))
    ]
    source = AnyLaunchDescriptionSource(needed(entity, parser, "file"))
    return actions.IncludeLaunchDescription(source, launch_arguments=pairs)


@action("group")
def _group(entity: Entity, parser: Parser) -> Action:
    kept = {
        parser.parse_substitution(one.required("name"))[0]: needed(one, parser, "value")
        for one in entity.inside("keep")
    }
    inside = [one for one in entity.children if one.type_name != "keep"]
    return actions.GroupAction(
        [parser.parse_action(one) for one in inside],
        scoped=truth(entity, "scoped", default=True),
        forwarding=truth(entity, "forwarding", default=True),
        launch_configurations=kept,
    )


@action("for")
def _for(entity: Entity, parser: Parser) -> Action:
    name = entity.required("name")
    parser.actions(entity)  # what is wrong inside shows even where there are no rounds

    def one_round(i: int) -> list[LaunchDescriptionEntity]:
        return in_a_round({name: i}, parser.actions(entity))

    return actions.ForLoop(needed(entity, parser, "len"), function=one_round, name=name)


@action("for_each")
def _for_each(entity: Entity, parser: Parser) -> Action:
    parser.actions(entity)  # as above

    def one_round(**values: Any) -> list[LaunchDescriptionEntity]:
        return in_a_round(values, parser.actions(entity))

    return actions.ForEach(needed(entity, parser, "values"), function=one_round)


@action("set_env")
def _set_env(entity: Entity, parser: Parser) -> Action:
    return actions.SetEnvironmentVariable(
        needed(entity, parser, "name"), needed(entity, parser, "value")
    )


@action("unset_env")
def _unset_env(entity: Entity, parser: Parser) -> Action:
    return actions.UnsetEnvironmentVariable(needed(entity, parser, "name"))


@action("append_env")
def _append_env(entity: Entity, parser: Parser) -> Action:
    return actions.AppendEnvironmentVariable(
        needed(entity, parser, "name"),
        needed(entity, parser, "value"),
        prepend=truth(entity, "prepend", default=False),
        separator=text(entity, parser, "separator") or os.pathsep,
    )


@action("rep_env")
def _replace_env(entity: Entity, parser: Parser) -> Action:
    return actions.ReplaceEnvironmentVariables(_environment(entity, parser))


@action("push_env")
def _push_env(_: Entity, __: Parser) -> Action:
    return actions.PushEnvironment()


@action("pop_env")
def _pop_env(_: Entity, __: Parser) -> Action:
    return actions.PopEnvironment()


@action("reset_env")
def _reset_env(_: Entity, __: Parser) -> Action:
    return actions.ResetEnvironment()


@action("unset_let", "unset_launch_configuration")
def _unset_let(entity: Entity, parser: Parser) -> Action:
    return actions.UnsetLaunchConfiguration(needed(entity, parser, "name"))


@action("reset")
def _reset(entity: Entity, parser: Parser) -> Action:
    kept = {
        parser.parse_substitution(one.required("name"))[0]: needed(one, parser, "value")
        for one in entity.inside("keep")
    }
    return actions.ResetLaunchConfigurations(kept)


@action("log")
def _log(entity: Entity, parser: Parser) -> Action:
    level = text(entity, parser, "level")
    if level is None:
        said = "`log` without a level means INFO; ROS 2 will ask for one: write `log_info`"
        warnings.warn(said, DeprecationWarning, stacklevel=2)
        level = [TextSubstitution(text="INFO")]
    return actions.Log(msg=needed(entity, parser, "message"), level=level)


_LOG_ACTIONS: Final[dict[str, type[actions.LogInfo]]] = {
    "debug": actions.LogDebug,
    "info": actions.LogInfo,
    "warning": actions.LogWarning,
    "error": actions.LogError,
}


@action("log_debug", "log_info", "log_warning", "log_error")
def _log_of_level(entity: Entity, parser: Parser) -> Action:
    level = entity.type_name.replace("-", "_").removeprefix("log_")
    return _LOG_ACTIONS[level](msg=needed(entity, parser, "message"))


@action("timer")
def _timer(entity: Entity, parser: Parser) -> Action:
    period = parser.parse_if_substitutions(entity.get_attr("period", data_type=float))
    return actions.TimerAction(period=period, actions=parser.actions(entity))


@action("shutdown")
def _shutdown(entity: Entity, parser: Parser) -> Action:
    return actions.Shutdown(reason=text(entity, parser, "reason") or "reason not given")


def executable_options(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return what the tag of a program says, as `ExecuteProcess` takes it."""
    shell = truth(entity, "shell", default=False)
    command = needed(entity, parser, "cmd")
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
