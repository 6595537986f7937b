"""Verbs of `zbot param`: list, get, set, delete, describe, dump and load parameters."""

from __future__ import annotations

import re
import shlex
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import typer

from zbot.errors import ZbotError
from zbot.parameters.file import sections
from zbot.parameters.parameter import Parameter, no_parameters_error
from zbot.remote.parameters import ParameterNotSetError, visible_nodes
from zbot.remote.service_calls import ANSWER_TIMEOUT_S
from zbot_cli.domain.client import full_name, hidden_node, nobody_runs, note_if_nobody_runs
from zbot_cli.domain.parameters import CommandParameters, in_words_of_ros2
from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.input.option_groups import with_option_groups
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import VISIBLE_NODES, AsJson, NodeSearch, new_app, print_json
from zbot_cli.output.parameter_text import (
    description,
    description_lines,
    file_text,
    message_of,
    plain_values,
    shown,
    values_for,
)

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

app = new_app("Look at parameters and set them")

NodeAndNames = Annotated[
    list[str],
    typer.Argument(metavar="[NODE] PARAM...", help="Without NODE: all nodes that have PARAM"),
]


# Texts for a change that a node accepts, and for a change that it rejects.
_SINGLE = ("Set parameter successful", "Setting parameter failed")
_ATOMIC = ("Set parameters atomically successful", "Setting parameters atomically failed")
_DELETED = ("Deleted parameter successfully", "Deleting parameter failed")


class ListCommand(ManyValuesCommand):
    """Command that reads several prefixes, as in `zbot param list --param-prefixes A B`."""

    many: ClassVar = frozenset({"--param-prefixes"})


@contextmanager
def _remote(
    timeout: float, answer_timeout: float = ANSWER_TIMEOUT_S
) -> Iterator[CommandParameters]:
    with hidden_node("param") as node:
        try:
            yield CommandParameters(node, timeout, answer_timeout)
        except ZbotError as error:
            raise in_words_of_ros2(error) from error


def _fail(error: object) -> None:
    print(in_words_of_ros2(error) if isinstance(error, ZbotError) else error, file=sys.stderr)


def _end(failures: int) -> None:
    if failures:
        raise typer.Exit(Status.ERROR)


# -- list --------------------------------------------------------------------------------------


@app.command("list", cls=ListCommand)
@with_option_groups
def list_parameters(
    node_name: Annotated[str | None, typer.Argument(help="Only this node")] = None,
    pattern: Annotated[
        str | None,
        typer.Option("--filter", help="Only names whose beginning matches this expression"),
    ] = None,
    prefixes: Annotated[
        list[str] | None, typer.Option("--param-prefixes", help="Only names below these prefixes")
    ] = None,
    show_types: Annotated[bool, typer.Option("--param-type", help="Add the types")] = False,
    service_timeout: Annotated[
        float, typer.Option("--service-timeout", help="Seconds to wait for each node's answer")
    ] = ANSWER_TIMEOUT_S,
    as_json: AsJson = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """List the parameters of nodes."""
    wanted = _compiled(pattern)
    with _remote(search.timeout, service_timeout) as remote:
        wanted_node = None if node_name is None else remote.find(node_name)
        nodes = (
            remote.nodes(include_hidden=search.include_hidden)
            if wanted_node is None
            else [wanted_node]
        )
        if not nodes:
            note_if_nobody_runs(remote.graph())
        answers = remote.all_names(nodes, prefixes or [])
        found = {node: list(filter(wanted.match, names)) for node, names in answers.found.items()}
        typed = {
            node: remote.types(node, names) if show_types or as_json else dict.fromkeys(names)
            for node, names in found.items()
        }
    for error in answers.errors.values():
        if wanted_node is not None:
            raise in_words_of_ros2(error)
        _fail(error)
    _print_names(typed, as_json=as_json, is_one=wanted_node is not None)
    _end(len(answers.errors))


def _compiled(pattern: str | None) -> re.Pattern[str]:
    try:
        return re.compile(pattern or "")
    except re.error as error:
        raise CommandError(f"--filter is not a regular expression: {error}") from error


def _print_names(typed: dict[str, dict[str, Any]], *, as_json: bool, is_one: bool) -> None:
    if as_json:
        lines = {
            node: [{"name": name, "type": type_.text} for name, type_ in sorted(names.items())]
            for node, names in typed.items()
        }
        print_json([{"node": node, "parameters": names} for node, names in lines.items()])
        return
    for node, names in typed.items():
        if names and not is_one:
            print(f"{node}:")
        for name, type_ in names.items():
            print(f"  {name}" + (f" (type: {type_.text})" if type_ is not None else ""))


# -- get ---------------------------------------------------------------------------------------


@app.command("get")
@with_option_groups
def get(
    words: NodeAndNames,
    hide_type: Annotated[bool, typer.Option("--hide-type", help="Print only the value")] = False,
    as_json: AsJson = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Print the values of parameters."""
    with _remote(search.timeout) as remote:
        nodes, names = _targets(remote, "get", words, include_hidden=search.include_hidden)
        values = {node: remote.values(node, names) for node in nodes}
    if as_json:
        print_json({node: plain_values(found) for node, found in values.items()})
        return
    for node, found in values.items():
        with _heading(node, is_shown=len(words) == 1) as indent:
            for name, parameter in found.items():
                if len(found) > 1:
                    print(f"{name}:\n  {shown(parameter, hide_type=hide_type)}")
                else:
                    print(indent + shown(parameter, hide_type=hide_type))


@contextmanager
def _heading(node: str, *, is_shown: bool) -> Iterator[str]:
    """Print a node's name if `is_shown`. Yield the indentation of the lines below it."""
    if is_shown:
        print(f"{node}:")
    yield "  " if is_shown else ""


def _targets(
    remote: CommandParameters, verb: str, words: Sequence[str], *, include_hidden: bool
) -> tuple[list[str], list[str]]:
    """Return nodes and parameters of `NODE PARAM...`. Without NODE, use all nodes with PARAM."""
    if len(words) > 1:
        return [remote.find(words[0])], list(words[1:])
    advice = _forgotten_word(remote, verb, words, "PARAM")
    return _nodes_with(remote, words, advice, include_hidden=include_hidden), list(words)


def _forgotten_word(
    remote: CommandParameters, verb: str, words: Sequence[str], missing: str
) -> str:
    """Return what to type if the first word is a node, and a word is missing at the end."""
    node = full_name(words[0])
    if node not in visible_nodes(remote.graph()):
        return ""
    return f"{node} is a node: type: zbot param {verb} {shlex.join(words)} {missing}"


def _nodes_with(
    remote: CommandParameters, names: Sequence[str], advice: str, *, include_hidden: bool
) -> list[str]:
    """Return the nodes that have all of these parameters.

    Raises:
        ParameterNotSetError: There is no such node. The hint is `advice`, if it is not empty.
    """
    nodes = remote.nodes(include_hidden=include_hidden)
    answers = remote.all_names(nodes)
    for error in answers.errors.values():
        _fail(error)
    found = [node for node, known in answers.found.items() if set(names) <= set(known)]
    if not found:
        known = sorted(set().union(*answers.found.values()))
        error = ParameterNotSetError(None, " and ".join(names), known)
        error.hint = advice or (error.hint if nodes else nobody_runs())
        raise error
    return found


# -- set and delete ----------------------------------------------------------------------------


@app.command("set", context_settings={"ignore_unknown_options": True})
@with_option_groups
def set_parameters(
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="[NODE] PARAM VALUE...", help="Without NODE: all nodes that have PARAM"
        ),
    ],
    atomic: Annotated[bool, typer.Option("--atomic", help="Set all parameters or none")] = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Set parameters."""
    _reject_options(words)
    has_node = len(words) % 2 == 1
    if len(words) < 2:
        raise typer.BadParameter(
            "needs the name of a parameter and its value, e.g. zbot param set /turtlesim "
            "background_r 150"
        )
    name, equals, value = words[-1].partition("=")
    if equals and not has_node and name.isidentifier():
        typed = [*words[:-1], name, value or "VALUE"]
        raise typer.BadParameter(f"write a blank, not '=': zbot param set {shlex.join(typed)}")
    if words[0].startswith("/") and not has_node:  # no name of a parameter begins with a slash
        raise typer.BadParameter(
            f"give each name a value: {words[-1]} has none; "
            f"type: zbot param set {shlex.join(words)} VALUE"
        )
    pairs = words[1:] if has_node else words
    values = dict(zip(pairs[::2], pairs[1::2], strict=True))
    messages = [message_of(name, text) for name, text in values.items()]
    failures = 0
    with _remote(search.timeout) as remote:
        nodes = (
            [remote.find(words[0])]
            if has_node
            else _nodes_with(
                remote,
                list(values),
                _forgotten_word(remote, "set", words, "VALUE"),
                include_hidden=search.include_hidden,
            )
        )
        for node in nodes:
            results = remote.set(node, messages, atomic=atomic)
            with _heading(node, is_shown=not has_node) as indent:
                if atomic:
                    failures += _report(indent, results[0], *_ATOMIC)
                    continue
                for name, result in zip(values, results, strict=True):
                    label = f"{indent}{name}: " if len(values) > 1 else indent
                    failures += _report(label, result, *_SINGLE)
    _end(failures)


def _reject_options(words: Sequence[str]) -> None:
    # Only words with two dashes are rejected, because -5 begins with a dash but is a value.
    for word in words:
        if word.startswith("--"):
            raise typer.BadParameter(f"there is no option {word}")


def _report(label: str, result: Any, success: str, failure: str) -> bool:
    """Print the result of one change. Return whether the change failed."""
    if result.successful:
        print(f"{label}{success}" + (f": {result.reason}" if result.reason else ""))
        return False
    _fail(f"{label}{failure}: {result.reason}")
    if result.reason.startswith("Wrong parameter type, expected 'string' "):
        _fail("\nhint: put a text that looks like a number into two kinds of quotes: \"'5'\"")
    return True


@app.command("delete")
@with_option_groups
def delete(
    words: NodeAndNames,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Delete parameters."""
    failures = 0
    with _remote(search.timeout) as remote:
        nodes, names = _targets(remote, "delete", words, include_hidden=search.include_hidden)
        for node in nodes:
            results = remote.set(node, [Parameter(name) for name in names])
            with _heading(node, is_shown=len(words) == 1) as indent:
                for name, result in zip(names, results, strict=True):
                    label = f"{indent}{name}: " if len(names) > 1 else indent
                    failures += _report(label, result, *_DELETED)
    _end(failures)


# -- describe, dump and load -------------------------------------------------------------------


@app.command("describe")
@with_option_groups
def describe(
    words: NodeAndNames,
    as_json: AsJson = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Show types, descriptions and limits of parameters."""
    with _remote(search.timeout) as remote:
        nodes, names = _targets(remote, "describe", words, include_hidden=search.include_hidden)
        found = {node: remote.descriptors(node, names) for node in nodes}
    if as_json:
        print_json({node: list(map(description, many)) for node, many in found.items()})
        return
    for node, descriptors in found.items():
        with _heading(node, is_shown=len(words) == 1) as indent:
            for descriptor in descriptors:
                for line in description_lines(descriptor):
                    print(indent + line)


@app.command("dump")
@with_option_groups
def dump(
    node_name: Annotated[
        str | None, typer.Argument(help="Name of the node; all nodes if left out")
    ] = None,
    as_json: AsJson = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Print parameters as a parameter file."""
    with _remote(search.timeout) as remote:
        wanted_nodes = None if node_name is None else [remote.find(node_name)]
        nodes = (
            remote.nodes(include_hidden=search.include_hidden)
            if wanted_nodes is None
            else wanted_nodes
        )
        values = {node: remote.values(node, remote.names(node)) for node in nodes}
    if as_json:
        print_json({node: plain_values(found) for node, found in values.items()})
    elif values:
        print(file_text(values))


@app.command("load")
@with_option_groups
def load(
    words: Annotated[
        list[str],
        typer.Argument(metavar="[NODE] FILE", help="Without NODE: all nodes with values in FILE"),
    ],
    no_use_wildcard: Annotated[
        bool, typer.Option("--no-use-wildcard", help="Leave out values that the file has for `/**`")
    ] = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Set parameters from a file."""
    if len(words) > 2:
        raise typer.BadParameter("takes a node and a file, or a file alone")
    path = words[-1]
    if len(words) == 1 and not Path(path).suffix and not Path(path).exists():
        raise CommandError(
            f"there is no file {path}", hint=f"name a file: zbot param load {path} FILE.yaml"
        )
    content = sections(path)
    failures = 0
    with _remote(search.timeout) as remote:
        has_node = len(words) == 2
        nodes = (
            [remote.find(words[0])]
            if has_node
            else remote.nodes(include_hidden=search.include_hidden)
        )
        wanted = {
            node: values_for(content, node, use_wildcards=not no_use_wildcard) for node in nodes
        }
        if not any(wanted.values()):
            raise no_parameters_error(path, nodes)
        for node, values in wanted.items():
            if values:
                with _heading(node, is_shown=not has_node) as indent:
                    failures += _load(remote, node, values, indent)
    _end(failures)


def _load(remote: CommandParameters, node: str, values: dict[str, Any], indent: str) -> int:
    """Set a file's values for one node. Return how many of the values the node still lacks."""
    parameters = remote.from_file(node, values)
    results = remote.set(node, parameters)
    refused = []
    for parameter, result in zip(parameters, results, strict=True):
        if result.successful:
            print(f"{indent}Set parameter {parameter.name} successful")
        else:
            _fail(f"{indent}Set parameter {parameter.name} failed: {result.reason}")
            refused.append(parameter)
    # A dump contains read-only parameters too, which the node refuses to set. A refusal counts as a
    # failure only if the node's value differs from the file's value.
    present = remote.known_values(node, [parameter.name for parameter in refused])
    return sum(
        parameter.name not in present or present[parameter.name].value != parameter.value
        for parameter in refused
    )
