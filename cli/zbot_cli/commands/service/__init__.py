"""Verbs of `zbot service`: list and show services, call them, and print their calls."""

from __future__ import annotations

from functools import partial
from typing import Annotated

import typer

from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import full_name, note_if_nobody_runs, snapshot
from zbot_cli.domain.kinds import SERVICE, visible
from zbot_cli.input.form_options import DEFAULT_FORM, FormOptions
from zbot_cli.input.option_groups import noun_option, with_option_groups
from zbot_cli.input.qos_options import DEFAULT_QOS, QosOptions
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

app = new_app("Look at services and call them")

#: Types of the services that every node has. Lists leave these services out, so that the services
#: of the user's own programs are easy to find.
NODE_SERVICE_TYPES = frozenset(
    {
        "rcl_interfaces/srv/DescribeParameters",
        "rcl_interfaces/srv/GetParameterTypes",
        "rcl_interfaces/srv/GetParameters",
        "rcl_interfaces/srv/ListParameters",
        "rcl_interfaces/srv/SetParameters",
        "rcl_interfaces/srv/SetParametersAtomically",
        "type_description_interfaces/srv/GetTypeDescription",
    }
)

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
        for name, types in visible(graph.services(), hidden)
        if hidden or not NODE_SERVICE_TYPES.issuperset(types)
    ]
    facts = partial(SERVICE.facts, graph)
    print_entries(services, facts, show_types=show_types, count=count, as_json=as_json)


@app.command("type")
@with_option_groups
def type_of(
    service_name: ServiceName,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Print a service's type."""
    print("\n".join(SERVICE.types_of(snapshot(), full_name(service_name))))


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
    from zbot_cli.output.endpoint import endpoint_json, endpoint_text  # noqa: PLC0415 - not needed by `list`

    graph, name = snapshot(), full_name(service_name)
    types = SERVICE.types_of(graph, name)
    clients, servers = (graph.on(name, kind) for kind in (EntityKind.CLIENT, EntityKind.SERVICE))
    if as_json:
        ends = {"clients": clients, "servers": servers}
        lists = {title: list(map(endpoint_json, ends[title])) for title in ends}
        print_json({"name": name, "types": types, **lists})
        return
    print(f"Type: {types[0] if len(types) == 1 else types}")
    print(f"Clients count: {len(clients)}")
    print(f"Services count: {len(servers)}")
    if verbose:
        for end in (*clients, *servers):
            print(endpoint_text(end, "Service") + "\n")


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
    hidden = include_hidden_services or noun_option(ctx, "include_hidden_services")
    found = SERVICE.with_type(snapshot(), service_type, include_hidden=hidden)
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
