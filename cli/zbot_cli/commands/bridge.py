"""Verbs of `zbot bridge`: connect the topics, services and actions of zbot and of ROS 2."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Annotated, ClassVar

import typer

from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.listing import new_app

if TYPE_CHECKING:
    from zbot.bridge.bridge import BridgeOptions

app = new_app("Carry topics, services and actions between zbot and ROS 2")


class BridgeCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset(
        {"--topics", "--services", "--actions", "--exclude", "--rate"}
    )


RosDomain = Annotated[
    int | None,
    typer.Option("--ros-domain", min=0, max=232, help="Domain of ROS 2; default: ROS_DOMAIN_ID"),
]
Topics = Annotated[
    list[str] | None,
    typer.Option(
        "--topics",
        help="Connect only these topics, e.g. /scan '/camera/*' /cmd_vel:out (:out is to ROS 2)",
    ),
]
Services = Annotated[
    list[str] | None,
    typer.Option(
        "--services", help="Connect only these services, e.g. '/arm/*:in' (:in is to zbot)"
    ),
]
Actions = Annotated[list[str] | None, typer.Option("--actions", help="Connect only these actions")]
Exclude = Annotated[list[str] | None, typer.Option("--exclude", help="Do not connect these names")]
Parameters = Annotated[
    bool, typer.Option("--parameters", help="Connect the parameters of nodes too")
]
Rate = Annotated[
    list[str] | None,
    typer.Option("--rate", help="Carry at most N messages per second: '/camera/*=5'"),
]
Prefix = Annotated[
    str, typer.Option("--prefix", help="Namespace in zbot for the names of ROS 2: robot1")
]


@app.callback()
def options() -> None:
    """Carry topics, services and actions between zbot and ROS 2."""


@app.command("dds", cls=BridgeCommand)
def dds(
    ros_domain: RosDomain = None,
    topics: Topics = None,
    services: Services = None,
    actions: Actions = None,
    exclude: Exclude = None,
    parameters: Parameters = False,
    rate: Rate = None,
    prefix: Prefix = "",
) -> None:
    """Connect this domain with ROS 2 over DDS.

    It runs until Ctrl-C. It connects all topics, services and actions, except those that every node
    has, e.g. `/rosout`.
    """
    from zbot.bridge.bridge import run_dds  # noqa: PLC0415 - not needed by `--help`

    run_dds(_options(ros_domain, topics, services, actions, exclude, parameters, rate, prefix))


@app.command("rmw_zenoh", cls=BridgeCommand)
def rmw_zenoh(
    connect: Annotated[
        str, typer.Option("--connect", help="Router of ROS 2: HOST, or tcp/HOST:7447")
    ] = "",
    ros_domain: RosDomain = None,
    topics: Topics = None,
    services: Services = None,
    actions: Actions = None,
    exclude: Exclude = None,
    parameters: Parameters = False,
    rate: Rate = None,
    prefix: Prefix = "",
) -> None:
    """Connect this domain with ROS 2 over Zenoh.

    It runs until Ctrl-C. It connects all topics, services and actions, except those that every node
    has, e.g. `/rosout`.
    """
    from dataclasses import replace  # noqa: PLC0415 - not needed by `--help`

    from zbot.bridge.bridge import run_rmw_zenoh  # noqa: PLC0415 - as above

    options = _options(ros_domain, topics, services, actions, exclude, parameters, rate, prefix)
    run_rmw_zenoh(replace(options, connect=_endpoint(connect)))


def _endpoint(address: str) -> str:
    """Return the Zenoh endpoint for an address: `robot`, `robot:7447` or `tcp/robot:7447`."""
    from zbot.classroom.hub.address import parse_address  # noqa: PLC0415 - not needed by `--help`

    return address if not address or "/" in address else parse_address(address).endpoint


def _options(
    ros_domain: int | None,
    topics: list[str] | None,
    services: list[str] | None,
    actions: list[str] | None,
    exclude: list[str] | None,
    parameters: bool,
    rate: list[str] | None,
    prefix: str,
) -> BridgeOptions:
    from zbot.bridge.bridge import BridgeOptions  # noqa: PLC0415 - not needed by `--help`
    from zbot.bridge.selection import Selection, patterns, read_rate  # noqa: PLC0415 - as above
    from zbot.names import validate_namespace  # noqa: PLC0415 - as above

    namespace = f"/{prefix.strip('/')}" if prefix.strip("/") else ""
    if namespace:
        validate_namespace(namespace)
    return BridgeOptions(
        ros_domain=_ros_domain(ros_domain),
        prefix=namespace,
        selection=Selection(
            topics=patterns(topics),
            services=patterns(services),
            actions=patterns(actions),
            excluded=patterns(exclude),
            parameters=parameters,
            rates=tuple(map(read_rate, rate or ())),
        ),
    )


def _ros_domain(given: int | None) -> int:
    from zbot.bridge.errors import BridgeError  # noqa: PLC0415 - not needed by `--help`

    if given is not None:
        return given
    text = os.environ.get("ROS_DOMAIN_ID", "").strip() or "0"
    if not text.isdecimal() or int(text) > 232:
        raise BridgeError(f"ROS_DOMAIN_ID is {text!r}: choose a number from 0 to 232")
    return int(text)
