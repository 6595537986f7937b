"""Verbs of `zbot service`: list and show services, call them, and print their calls."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer

from zbot.names import fully_qualified, is_hidden
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import full_name, note_if_nobody_runs, snapshot
from zbot_cli.domain.service_types import NODE_SERVICE_TYPES, known_services, unknown_service_error
from zbot_cli.domain.types import check_known
from zbot_cli.input.form_options import DEFAULT_FORM, FormOptions
from zbot_cli.input.option_groups import noun_option, with_option_groups
from zbot_cli.input.qos_options import DEFAULT_QOS, QosOptions, profile_lines
from zbot_cli.output.listing import (
    NO_DAEMON,
    AsJson,
    DaemonOptions,
    ShowTypes,
    new_app,
    print_entries,
    print_json,
    print_names,
)

if TYPE_CHECKING:
    from zbot.graph.snapshot import NamesAndTypes, Snapshot
    from zbot.wire.tokens import EndpointToken

app = new_app("Look at services and call them")

IncludeHidden = Annotated[
    bool,
    typer.Option(
        "-a",
        "--include-hidden-services",
        help="Include hidden services and the services that every node has",
    ),
]
Count = Annotated[bool, typer.Option("-c", "--count-services", "--count", help="Print the number")]
ServiceName = Annotated[str, typer.Argument(help="Name of the service, e.g. /add_two_ints")]


@app.callback()
def options(
    include_hidden_services: Annotated[
        bool, typer.Option("--include-hidden-services", help="Consider hidden services too")
    ] = False,
) -> None:
    """Look at services and call them."""


def _shown(services: NamesAndTypes, include_hidden: bool) -> NamesAndTypes:
    return [entry for entry in services if include_hidden or not is_hidden(entry[0])]


@app.command("list")
@with_option_groups
def list_services(
    ctx: typer.Context,
    show_types: ShowTypes = False,
    count: Count = False,
    include_hidden_services: IncludeHidden = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """List the services that have a server."""
    graph = snapshot()
    note_if_nobody_runs(graph)
    hidden = include_hidden_services or noun_option(ctx, "include_hidden_services")
    services = [
        (name, types)
        for name, types in _shown(graph.services(), hidden)
        if hidden or not NODE_SERVICE_TYPES.issuperset(types)
    ]
    facts = partial(_facts, graph)
    print_entries(services, facts, show_types=show_types, count=count, as_json=as_json)


def _facts(graph: Snapshot, name: str, types: list[str]) -> dict[str, object]:
    return {
        "name": name,
        "types": types,
        "server_count": len(graph.on(name, EntityKind.SERVICE)),
        "client_count": len(graph.on(name, EntityKind.CLIENT)),
    }


@app.command("type")
@with_option_groups
def type_of(
    service_name: ServiceName,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Print a service's type."""
    print("\n".join(_types(snapshot(), full_name(service_name))))


def _types(graph: Snapshot, name: str) -> list[str]:
    types = dict(known_services(graph)).get(name)
    if types is None:
        raise unknown_service_error(name, graph)
    return types


@app.command("info")
@with_option_groups
def info(
    service_name: ServiceName,
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Show every server and client")
    ] = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Show a service's type, clients and servers."""
    graph, name = snapshot(), full_name(service_name)
    types = _types(graph, name)
    clients, servers = (graph.on(name, one) for one in (EntityKind.CLIENT, EntityKind.SERVICE))
    if as_json:
        sides = {"clients": clients, "servers": servers}
        ends = {side: [_endpoint_dict(end) for end in found] for side, found in sides.items()}
        print_json({"name": name, "types": types, **ends})
        return
    print(f"Type: {types[0] if len(types) == 1 else types}")
    print(f"Clients count: {len(clients)}")
    print(f"Services count: {len(servers)}")
    if verbose:
        for end in (*clients, *servers):
            print(_endpoint_text(end) + "\n")


def _endpoint_dict(end: EndpointToken) -> dict[str, object]:
    return {
        "node": fully_qualified(end.namespace, end.node),
        "type": end.type_name,
        "type_hash": end.type_hash,
        "gid": end.gid.hex(),
    }


def _endpoint_text(end: EndpointToken) -> str:

    gid = ".".join(f"{byte:02x}" for byte in end.gid)
    return "\n".join(
        (
            f"Node name: {end.node}",
            f"Node namespace: {end.namespace}",
            f"Service type: {end.type_name}",
            f"Service type hash: {end.type_hash}",
            f"Endpoint type: {'CLIENT' if end.kind is EntityKind.CLIENT else 'SERVER'}",
            "Endpoint count: 1",
            f"GID: {gid}",
            "QoS profile:",
            *profile_lines(end.qos),
        )
    )


@app.command("find")
@with_option_groups
def find(
    ctx: typer.Context,
    service_type: Annotated[
        str, typer.Argument(help="Type of the service, e.g. std_srvs/srv/SetBool")
    ],
    count: Count = False,
    include_hidden_services: IncludeHidden = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """List the services that have the given type."""
    services = snapshot().services()
    wanted = check_known(service_type, "srv", {one for _, types in services for one in types})
    hidden = include_hidden_services or noun_option(ctx, "include_hidden_services")
    found = [name for name, types in _shown(services, hidden) if wanted in types]
    print_names(found, count=count, as_json=as_json)


@app.command("call")
@with_option_groups
def call(
    service_name: ServiceName,
    words: Annotated[
        list[str] | None,
        typer.Argument(help="Type and request; both may be left out", metavar="[TYPE] [REQUEST]"),
    ] = None,
    rate: Annotated[
        float | None, typer.Option("-r", "--rate", metavar="N", help="Call N times a second")
    ] = None,
    timeout: Annotated[
        float | None,
        typer.Option("--timeout", help="Seconds to wait for the server and its response"),
    ] = None,
    stdin: Annotated[
        bool, typer.Option("--stdin", help="Read the request from standard input")
    ] = False,
    qos: QosOptions = DEFAULT_QOS,
    as_json: AsJson = False,
) -> None:
    """Call a service."""
    from zbot_cli.commands.service.call import ServiceCall  # noqa: PLC0415 - not needed by `list`

    ServiceCall(
        full_name(service_name),
        words or [],
        qos,
        rate_hz=rate,
        timeout_s=timeout,
        stdin=stdin,
        as_json=as_json,
    ).run()


@app.command("echo")
@with_option_groups
def echo(
    service_name: ServiceName,
    service_type: Annotated[
        str | None, typer.Argument(help="Type of the service, if no node uses it yet")
    ] = None,
    qos: QosOptions = DEFAULT_QOS,
    form: FormOptions = DEFAULT_FORM,
    as_json: AsJson = False,
) -> None:
    """Print the calls of a service."""
    from zbot_cli.commands.service.echo import ServiceEcho  # noqa: PLC0415 - not needed by `list`

    ServiceEcho(full_name(service_name), service_type, form.form(as_json=as_json), qos).run()
