"""Verbs of `zbot lifecycle`: list managed nodes, show their states, and change their states."""

from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Any

import typer

from zbot.graph.snapshot import full_names
from zbot.remote.managed_nodes import ManagedNodes, NodeSilentError, managed_nodes
from zbot.threads.deadline import Deadline
from zbot_cli.domain.client import full_name, hidden_node, note_if_nobody_runs, snapshot
from zbot_cli.domain.waiting import wait_until_found
from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import as_typed, did_you_mean
from zbot_cli.input.option_groups import with_option_groups
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import (
    NO_DAEMON,
    VISIBLE_NODES,
    AsJson,
    DaemonOptions,
    NodeSearch,
    new_app,
    print_json,
    print_names,
)

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node

    from lifecycle_msgs.msg import State, TransitionDescription

app = new_app("Look at managed nodes and change their states")

NodeName = Annotated[str, typer.Argument(help="Name of the node, e.g. /lc_talker")]


@contextmanager
def _managed(name: str, timeout: float) -> Iterator[tuple[ManagedNodes, str]]:
    """Yield a client of managed nodes, and the full name of a node as soon as it is running."""
    with hidden_node("lifecycle") as node:
        yield ManagedNodes(node), _find_managed_node(node, name, timeout)


@app.command("nodes")
@with_option_groups
def nodes(
    show_all: Annotated[
        bool, typer.Option("-a", "--all", "--include-hidden-nodes", help="Show hidden nodes too")
    ] = False,
    count: Annotated[
        bool, typer.Option("-c", "--count-nodes", "--count", help="Print the number")
    ] = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """List the managed nodes that are running."""
    graph = snapshot()
    note_if_nobody_runs(graph)
    names = managed_nodes(graph, include_hidden=show_all)
    print_names(names, count=count, as_json=as_json)


@app.command("get")
@with_option_groups
def get(
    node_name: Annotated[
        str | None, typer.Argument(help="Name of the node; without it, all managed nodes")
    ] = None,
    as_json: AsJson = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Print the states of managed nodes."""
    if node_name is not None:
        with _managed(node_name, search.timeout) as (remote, name):
            state = remote.state(name)
        if as_json:
            print_json(_plain(state))
        else:
            print(f"{state.label} [{state.id}]")
        return
    with hidden_node("lifecycle") as node:
        found = managed_nodes(node.context.graph.snapshot(), include_hidden=search.include_hidden)
        answers = ManagedNodes(node).states(found)
    silent = [answer for answer in answers.values() if isinstance(answer, NodeSilentError)]
    states = {
        name: answer for name, answer in answers.items() if not isinstance(answer, NodeSilentError)
    }
    if as_json:
        print_json({name: _plain(state) for name, state in states.items()})
    else:
        for name, state in states.items():
            print(f"{name}: {state.label} [{state.id}]")
    for error in silent:
        print(error, file=sys.stderr)
    if silent:
        raise typer.Exit(Status.ERROR)


def _plain(state: State) -> dict[str, Any]:
    return {"id": state.id, "label": state.label}


@app.command("list")
@with_option_groups
def list_transitions(
    node_name: NodeName,
    show_all: Annotated[
        bool, typer.Option("-a", "--all", help="List all transitions, also those not possible now")
    ] = False,
    as_json: AsJson = False,
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """List the transitions that a node allows now."""
    with _managed(node_name, search.timeout) as (remote, name):
        found = remote.transitions(name, show_all=show_all)
    if as_json:
        print_json([_plain_transition(description) for description in found])
        return
    for description in found:
        print(f"- {description.transition.label} [{description.transition.id}]")
        print(f"\tStart: {description.start_state.label}\n\tGoal: {description.goal_state.label}")


def _plain_transition(description: TransitionDescription) -> dict[str, Any]:
    return {
        "id": description.transition.id,
        "label": description.transition.label,
        "start": description.start_state.label,
        "goal": description.goal_state.label,
    }


@app.command("set")
@with_option_groups
def set_state(
    node_name: NodeName,
    transition: Annotated[str, typer.Argument(help="Label or number, e.g. configure or 1")],
    search: NodeSearch = VISIBLE_NODES,
) -> None:
    """Change the state of a node."""
    with _managed(node_name, search.timeout) as (remote, name):
        remote.change(name, transition)
    print("Transitioning successful")


def _node_not_found_error(name: str, graph: Snapshot) -> CommandError:
    """Return the error that no managed node of that name appeared in time."""
    if name in (names := full_names(graph.nodes)):
        return CommandError(
            "Node not found", hint=f"{name} is running, but it is not a managed node"
        )
    known = managed_nodes(graph, include_hidden=True)
    others = f"managed nodes are {', '.join(known)}" if known else "no managed node is running"
    reason = did_you_mean(name, known) or did_you_mean(name, names) or others
    return CommandError("Node not found", hint=f"no node {as_typed(name)} is running; {reason}")


def _find_managed_node(node: Node, name: str, timeout_s: float) -> str:
    """Return a managed node's full name as soon as it is running.

    Args:
        node: The node of the command.
        name: The name on the command line.
        timeout_s: Seconds to wait for a node that is not running yet.

    Raises:
        CommandError: The node does not appear in time.
        ExternalShutdownException: The context ended first.
    """
    full = full_name(name)

    def find(graph: Snapshot) -> str | None:
        return full if full in managed_nodes(graph, include_hidden=True) else None

    if wait_until_found(node, find, Deadline(timeout_s)) is None:
        raise _node_not_found_error(full, node.context.graph.snapshot())
    return full
