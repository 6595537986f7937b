"""Verbs of `zbot action`: list actions, show their servers and clients, and send goals."""

from __future__ import annotations

import sys
from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer

from zbot.names import fully_qualified, validate_topic_name
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.action_types import suggestion, unknown_action_error
from zbot_cli.domain.client import full_name, note_if_nobody_runs, snapshot
from zbot_cli.domain.types import check_known
from zbot_cli.input.form_options import DEFAULT_FORM, FormOptions
from zbot_cli.input.option_groups import with_option_groups
from zbot_cli.output.listing import (
    AsJson,
    ShowTypes,
    new_app,
    print_entries,
    print_json,
    print_names,
)

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot

app = new_app("Look at actions and send goals")

ActionName = Annotated[str, typer.Argument(help="Name of the action, e.g. /fibonacci")]
Count = Annotated[bool, typer.Option("-c", "--count", help="Print the number")]


@app.command("list")
def list_actions(
    show_types: ShowTypes = False,
    count: Annotated[
        bool, typer.Option("-c", "--count-actions", "--count", help="Print the number")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """List the actions that have servers or clients."""
    graph = snapshot()
    note_if_nobody_runs(graph)
    facts = partial(_facts, graph)
    print_entries(graph.actions(), facts, show_types=show_types, count=count, as_json=as_json)


def _facts(graph: Snapshot, name: str, types: list[str]) -> dict[str, object]:
    return {
        "name": name,
        "types": types,
        "server_count": len(_nodes(graph, name, EntityKind.SERVICE)),
        "client_count": len(_nodes(graph, name, EntityKind.CLIENT)),
    }


def _nodes(graph: Snapshot, name: str, kind: EntityKind) -> dict[str, list[str]]:
    """Return the nodes that are servers or clients of an action, and the types that they use."""
    found: dict[str, list[str]] = {}
    for node in graph.nodes:
        full = fully_qualified(node.namespace, node.node)
        types = dict(graph.actions(kind, node=full)).get(name)  # type: ignore[arg-type]
        if types is not None:
            found[full] = types
    return found


@app.command("info")
def info(
    action_name: ActionName,
    show_types: ShowTypes = False,
    count: Annotated[bool, typer.Option("-c", "--count", help="Print the numbers only")] = False,
    as_json: AsJson = False,
) -> None:
    """Show an action's servers and clients."""
    graph, name = snapshot(), _checked(action_name)
    sides = {
        side: _nodes(graph, name, kind)
        for side, kind in (("clients", EntityKind.CLIENT), ("servers", EntityKind.SERVICE))
    }
    if as_json:
        ends = {
            side: [{"node": node, "types": types} for node, types in nodes.items()]
            for side, nodes in sides.items()
        }
        print_json({"name": name, **ends})
        return
    print(f"Action: {name}")
    for side, nodes in sides.items():
        print(f"Action {side}: {len(nodes)}")
        for node, types in () if count else nodes.items():
            print(f"    {node} [{', '.join(types)}]" if show_types else f"    {node}")
    hint = "" if any(sides.values()) else suggestion(name, graph)
    if hint:
        print(f"\nhint: {hint}", file=sys.stderr)


def _checked(action_name: str) -> str:
    validate_topic_name(action_name)
    return full_name(action_name)


@app.command("type")
def type_of(action_name: ActionName) -> None:
    """Print an action's type."""
    graph, name = snapshot(), _checked(action_name)
    types = dict(graph.actions()).get(name)
    if types is None:
        raise unknown_action_error(name, graph)
    print("\n".join(types))


@app.command("find")
def find(
    action_type: Annotated[
        str, typer.Argument(help="Type of the action, e.g. example_interfaces/action/Fibonacci")
    ],
    count: Annotated[
        bool, typer.Option("-c", "--count-actions", "--count", help="Print the number")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """List the actions that have the given type."""
    actions = snapshot().actions()
    wanted = check_known(action_type, "action", {one for _, types in actions for one in types})
    found = [name for name, types in actions if wanted in types]
    print_names(found, count=count, as_json=as_json)


@app.command("send_goal")
def send_goal(
    action_name: ActionName,
    words: Annotated[
        list[str] | None,
        typer.Argument(help="Type and goal; both may be left out", metavar="[TYPE] [GOAL]"),
    ] = None,
    feedback: Annotated[
        bool, typer.Option("-f", "--feedback", help="Print the feedback too")
    ] = False,
    timeout: Annotated[
        float | None, typer.Option("-t", "--timeout", help="Seconds to wait for a server")
    ] = None,
    stdin: Annotated[
        bool, typer.Option("--stdin", help="Read the goal from standard input")
    ] = False,
    goal_file: Annotated[
        str | None, typer.Option("--goal-file", help="Read the goal from a YAML file")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Send a goal; Ctrl-C cancels it."""
    from zbot_cli.commands.action.send_goal import SendGoal  # noqa: PLC0415 - not needed by `list`

    code = SendGoal(
        _checked(action_name),
        words or [],
        with_feedback=feedback,
        timeout_s=timeout,
        stdin=stdin,
        goal_file=goal_file,
        as_json=as_json,
    ).run()
    raise typer.Exit(code)


@app.command("echo")
@with_option_groups
def echo(
    action_name: ActionName,
    action_type: Annotated[
        str | None, typer.Argument(help="Type of the action, if no node uses it yet")
    ] = None,
    interfaces: Annotated[
        str | None,
        typer.Option(
            "-i", "--interfaces", help="Print only these, e.g. 'FEEDBACK_TOPIC|STATUS_TOPIC'"
        ),
    ] = None,
    form: FormOptions = DEFAULT_FORM,
    as_json: AsJson = False,
) -> None:
    """Print an action's feedback, status and service events."""
    from zbot_cli.commands.action.echo import ActionEcho  # noqa: PLC0415 - not needed by `list`

    ActionEcho(_checked(action_name), action_type, interfaces, form.form(as_json=as_json)).run()
