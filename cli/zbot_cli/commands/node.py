"""Verbs of `zbot node`: list nodes, show their endpoints, and end their processes."""

from __future__ import annotations

import sys
from collections import Counter
from typing import TYPE_CHECKING, Annotated

import typer

from zbot.graph.snapshot import full_names
from zbot.names import is_hidden
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import (
    client,
    full_name,
    note_if_nobody_runs,
    print_stopped_programs,
    snapshot,
    snapshot_of,
)
from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import as_typed, did_you_mean
from zbot_cli.input.option_groups import with_option_groups
from zbot_cli.output.listing import NO_DAEMON, AsJson, DaemonOptions, new_app, print_json

if TYPE_CHECKING:
    from zbot.graph.snapshot import NamesAndTypes, Snapshot
    from zbot.transport.admin_query import Process
    from zbot.wire.tokens import NodeToken

app = new_app("Look at nodes")

#: Type of the service with which each node describes its message types. `info` leaves this service
#: out, as ros2 does.
_TYPE_DESCRIPTION = "type_description_interfaces/srv/GetTypeDescription"
#: The keys in JSON of the groups that `info` prints.
_KEYS = {
    "Subscribers": "subscriptions",
    "Publishers": "publishers",
    "Service Servers": "service_servers",
    "Service Clients": "service_clients",
    "Action Servers": "action_servers",
    "Action Clients": "action_clients",
}


def unknown_node_name_error(name: str, known: list[str]) -> CommandError:
    """Return the error that no node of that name is running. The hint contains a similar name."""
    hint = did_you_mean(name, known)
    return CommandError(f"Unable to find node '{as_typed(name)}'", hint=hint)


@app.command("list")
@with_option_groups
def list_nodes(
    show_all: Annotated[bool, typer.Option("-a", "--all", help="Show hidden nodes too")] = False,
    count: Annotated[
        bool, typer.Option("-c", "--count-nodes", "--count", help="Print the number")
    ] = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """List the nodes that are running."""
    graph = snapshot()
    note_if_nobody_runs(graph)
    nodes = [node for node in graph.nodes if show_all or not is_hidden(node.full_node_name)]
    names = full_names(nodes)
    print_stopped_programs()
    if count:
        print(len(names))
    elif as_json:
        print_json([_facts(node) for node in nodes])
    else:
        _warn_of_duplicates(names)
        for name in names:
            print(name)


def _facts(node: NodeToken) -> dict[str, str]:
    return {"node": node.full_node_name, "name": node.node, "namespace": node.namespace}


def _warn_of_duplicates(names: list[str]) -> None:
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        print(
            "WARNING: Be aware that there are nodes in the graph that share an exact name, "
            f"which can have unintended side effects: {', '.join(twice)}",
            file=sys.stderr,
        )


@app.command("info")
@with_option_groups
def info(
    node_name: Annotated[str, typer.Argument(help="Name of the node, e.g. /talker")],
    include_hidden: Annotated[
        bool, typer.Option("--include-hidden", help="Show hidden names too")
    ] = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Show a node's topics, services and actions."""
    graph = snapshot()
    name = full_name(node_name)
    found = full_names(graph.nodes).count(name)
    if not found:
        raise unknown_node_name_error(name, full_names(graph.nodes))
    if found > 1:
        print(
            f"There are {found} nodes in the graph with the exact name '{name}'. You are seeing "
            "information about all of them.",
            file=sys.stderr,
        )
    groups = _groups(graph, name, include_hidden=include_hidden)
    if as_json:
        lists = {_KEYS[title]: dict(group) for title, group in groups.items()}
        print_json({"node": name, **lists})
        return
    print(name)
    for title, group in groups.items():
        print(f"  {title}:")
        print("\n".join(f"    {entry}: {', '.join(types)}" for entry, types in group))


def _groups(graph: Snapshot, node: str, *, include_hidden: bool) -> dict[str, NamesAndTypes]:
    kinds = {
        "Subscribers": EntityKind.SUBSCRIPTION,
        "Publishers": EntityKind.PUBLISHER,
        "Service Servers": EntityKind.SERVICE,
        "Service Clients": EntityKind.CLIENT,
    }
    groups = {
        title: [
            (name, types)
            for name, types in graph.names_and_types(kind, node=node)
            if include_hidden or not (is_hidden(name) or types == [_TYPE_DESCRIPTION])
        ]
        for title, kind in kinds.items()
    }
    groups["Action Servers"] = graph.actions(EntityKind.SERVICE, node=node)
    groups["Action Clients"] = graph.actions(EntityKind.CLIENT, node=node)
    return groups


@app.command("kill")
def kill(
    node_name: Annotated[str, typer.Argument(help="Name of the node, e.g. /talker")],
    force: Annotated[
        bool, typer.Option("-f", "--force", help="Kill the process without letting it clean up")
    ] = False,
) -> None:
    """End the process that a node runs in."""
    name = full_name(node_name)
    with client() as context:
        nodes = snapshot_of(context).nodes
        sessions = {node.zid for node in nodes if node.full_node_name == name}
        if not sessions:
            raise unknown_node_name_error(name, full_names(nodes))
        known = _processes(context)
        for zid in sessions:
            _end(name, known.get(zid), force=force)


def _processes(context: object) -> dict[str, Process]:
    from zbot.transport.admin_query import processes  # noqa: PLC0415 - needed only for this verb

    return processes(context.session)  # type: ignore[attr-defined]


def _check_own(name: str) -> None:
    """Raise `CommandError` if a teacher wants to end the node of a student."""
    from zbot.transport import config, membership  # noqa: PLC0415 - needed only by this verb

    joined, domain = membership.load(), config.domain_id()
    if joined is not None and joined.role == "teacher" and domain:
        raise CommandError(
            f"{name} runs on the laptop of student {domain}, and a teacher cannot end programs "
            f"there: ask the student to type `zbot node kill {name}`"
        )


def _end(name: str, process: Process | None, *, force: bool) -> None:
    import os  # noqa: PLC0415 - needed only by this verb
    import signal  # noqa: PLC0415 - needed only by this verb

    if process is None:
        _check_own(name)
        raise CommandError(f"the process of {name} does not publish its pid; end it where it runs")
    if not process.is_here:
        raise CommandError(f"{name} runs on {process.host} (pid {process.pid}); end it there")
    # On Windows SIGTERM ends a process immediately, as SIGKILL does elsewhere.
    number = signal.SIGTERM
    if sys.platform != "win32" and force:
        number = signal.SIGKILL
    try:
        os.kill(process.pid, number)
    except PermissionError:
        raise CommandError(f"the process {process.pid} of {name} belongs to another user") from None
    except OSError:  # Windows has no ProcessLookupError for a number that no process has
        raise CommandError(f"the process {process.pid} of {name} has already ended") from None
    print(f"{name}: ended process {process.pid} ({process.command})")
