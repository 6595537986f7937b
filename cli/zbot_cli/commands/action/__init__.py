"""Verbs of `zbot action`: list actions, show their servers and clients, and send goals."""

from __future__ import annotations

import sys
from functools import partial
from typing import Annotated

import typer

from zbot.names import validate_topic_name
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import full_name, note_if_nobody_runs, snapshot
from zbot_cli.domain.kinds import ACTION, nodes_of_action
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
    facts = partial(ACTION.facts, graph)
    print_entries(graph.actions(), facts, show_types=show_types, count=count, as_json=as_json)


@app.command("info")
def info(
    action_name: ActionName,
    show_types: ShowTypes = False,
    count: Annotated[bool, typer.Option("-c", "--count", help="Print the numbers only")] = False,
    as_json: AsJson = False,
) -> None:
    """Show an action's servers and clients."""
    graph, name = snapshot(), _checked(action_name)
    ends = {
        "clients": nodes_of_action(graph, name, EntityKind.CLIENT),
        "servers": nodes_of_action(graph, name, EntityKind.SERVICE),
    }
    if as_json:
        lists = {
            title: [{"node": node, "types": types} for node, types in nodes.items()]
            for title, nodes in ends.items()
        }
        print_json({"name": name, **lists})
        return
    print(f"Action: {name}")
    for title, nodes in ends.items():
        print(f"Action {title}: {len(nodes)}")
        for node, types in () if count else nodes.items():
            print(f"    {node} [{', '.join(types)}]" if show_types else f"    {node}")
    hint = "" if any(ends.values()) else ACTION.suggestion(graph, name)
    if hint:
        print(f"\nhint: {hint}", file=sys.stderr)


def _checked(action_name: str) -> str:
    validate_topic_name(action_name)
    return full_name(action_name)


@app.command("type")
def type_of(action_name: ActionName) -> None:
    """Print an action's type."""
    print("\n".join(ACTION.types_of(snapshot(), _checked(action_name))))


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
    found = ACTION.with_type(snapshot(), action_type, include_hidden=True)
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
