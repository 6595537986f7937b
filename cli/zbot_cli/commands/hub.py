"""`zbot hub`: runs a router that links machines without a classroom."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from zbot_cli.errors import CommandError
from zbot_cli.output.listing import new_app

app = new_app("Link other machines to this one", has_verbs=False)


@app.command()
def hub(
    listen: Annotated[
        list[str] | None,
        typer.Option("--listen", help="ADDRESS[:PORT] to listen on; 0.0.0.0:7447 by default"),
    ] = None,
    connect: Annotated[
        list[str] | None, typer.Option("--connect", help="HOST[:PORT] of another hub")
    ] = None,
    keystore: Annotated[
        Path | None, typer.Option("--keystore", help="Folder of this machine's certificate")
    ] = None,
    boards: Annotated[
        bool,
        typer.Option("--boards", help="Link microcontrollers (zenoh-pico) with this domain"),
    ] = False,
    ros_domain: Annotated[
        int | None,
        typer.Option(
            "--ros-domain",
            min=0,
            max=232,
            help="With --boards: domain of the boards; default: ROS_DOMAIN_ID",
        ),
    ] = None,
) -> None:
    """Link the machines that join this one, until Ctrl-C.

    With --rmw, run the router of ROS 2's nodes, like rmw_zenohd. With --boards, run this router and
    `zbot bridge rmw_zenoh`: boards with Pico-ROS are nodes of this domain.
    """
    if boards:
        _serve_boards(listen, connect, keystore, ros_domain)
        return
    from zbot.transport.rmw_choice import RMW_VARIABLE, RMW_ZENOH  # noqa: PLC0415 - not for --help

    if os.environ.get(RMW_VARIABLE) == RMW_ZENOH:
        _serve_ros2(listen, connect, keystore)
        return
    from zbot.classroom.hub.address import (  # noqa: PLC0415 - not needed by `--help`
        EVERYWHERE,
        own_addresses,
        parse_address,
    )
    from zbot.classroom.hub.link import Link  # noqa: PLC0415 - as above
    from zbot.classroom.hub.process import serve  # noqa: PLC0415 - as above
    from zbot.classroom.hub.router import HubSettings  # noqa: PLC0415 - as above

    addresses = [parse_address(word) for word in listen or [EVERYWHERE]]
    dialled = [parse_address(word) for word in connect or []]
    link = Link.named(keystore)
    if not keystore:
        listening = [address.endpoint for address in addresses]
    else:
        for host in own_addresses()[:1]:
            link.check_listening(host)
        for address in dialled:
            link.check_dialling(address)
        listening = [endpoint for address in addresses for endpoint in link.listening(address)]
    settings = HubSettings(
        tuple(dict.fromkeys(listening)),
        tuple(link.endpoint(address) for address in dialled),
        link.settings,
    )

    def print_addresses() -> None:
        print(f"the hub listens on {', '.join(map(str, addresses))}; Ctrl-C ends it")
        for host in own_addresses()[:1]:
            port = addresses[0].port
            shown = host if port == parse_address(host).port else f"{host}:{port}"
            print(f"on the other machines: zbot join {shown}", flush=True)

    serve("hub", lambda: settings, print_addresses)


def _serve_ros2(listen: list[str] | None, connect: list[str] | None, keystore: Path | None) -> None:
    from zbot.classroom.hub.address import parse_address  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.hub.process import serve_session  # noqa: PLC0415 - as above
    from zbot.transport.rmw_meeting import RmwRouter  # noqa: PLC0415 - as above

    if keystore is not None:
        raise CommandError(
            "`zbot hub --rmw` has no option --keystore: write TLS into the file that "
            "ZENOH_ROUTER_CONFIG_URI names"
        )
    router = RmwRouter(
        [parse_address(word).endpoint for word in listen or []],
        [parse_address(word).endpoint for word in connect or []],
    )
    known = ", ".join(router.listen)
    serve_session(
        router.open,
        lambda: print(f"the router of ROS 2 listens on {known}; Ctrl-C ends it", flush=True),
    )


def _serve_boards(
    listen: list[str] | None,
    connect: list[str] | None,
    keystore: Path | None,
    ros_domain: int | None,
) -> None:
    from zbot.bridge.boards import run_boards  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.hub.address import (  # noqa: PLC0415 - as above
        EVERYWHERE,
        Address,
        own_addresses,
        parse_address,
    )
    from zbot_cli.commands.bridge import RouteOptions  # noqa: PLC0415 - as above

    if connect or keystore is not None:
        raise CommandError("`zbot hub --boards` has only the options --listen and --ros-domain")

    given = [parse_address(word) for word in listen or []]
    hosts = [address.host for address in given if address.host not in {EVERYWHERE, "::"}]

    def print_address(port: int) -> None:
        shown = Address((hosts or own_addresses() or ["127.0.0.1"])[0], port)
        print(f"on the board: {shown.endpoint}", flush=True)

    endpoints = [address.endpoint for address in given]
    run_boards(
        RouteOptions(ros_domain=ros_domain, parameters=True).for_bridge(), endpoints, print_address
    )
