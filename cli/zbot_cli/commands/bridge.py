"""Verbs of `zbot bridge`: connect the topics, services and actions of zbot and of ROS 2."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar, Final

import typer

from zbot.text.whole_number import whole_number
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.input.option_groups import with_option_groups
from zbot_cli.output.listing import new_app

if TYPE_CHECKING:
    from zbot.bridge.bridge import BridgeOptions

app = new_app("Carry topics, services and actions between zbot and ROS 2")


class BridgeCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset(
        {"--topics", "--services", "--actions", "--exclude", "--rate"}
    )


@dataclass(frozen=True)
class RouteOptions:
    """Group of the options that say what a bridge connects."""

    ros_domain: Annotated[
        int | None,
        typer.Option(
            "--ros-domain", min=0, max=232, help="Domain of ROS 2; default: ROS_DOMAIN_ID"
        ),
    ] = None
    topics: Annotated[
        list[str] | None,
        typer.Option(
            "--topics",
            help="Connect only these topics, e.g. /scan '/camera/*' /cmd_vel:out "
            "(:out is to ROS 2)",
        ),
    ] = None
    services: Annotated[
        list[str] | None,
        typer.Option(
            "--services", help="Connect only these services, e.g. '/arm/*:in' (:in is to zbot)"
        ),
    ] = None
    actions: Annotated[
        list[str] | None, typer.Option("--actions", help="Connect only these actions")
    ] = None
    exclude: Annotated[
        list[str] | None, typer.Option("--exclude", help="Do not connect these names")
    ] = None
    parameters: Annotated[
        bool, typer.Option("--parameters", help="Connect the parameters of nodes too")
    ] = False
    rate: Annotated[
        list[str] | None,
        typer.Option("--rate", help="Carry at most N messages per second: '/camera/*=5'"),
    ] = None
    prefix: Annotated[
        str, typer.Option("--prefix", help="Namespace in zbot for the names of ROS 2: robot1")
    ] = ""

    def for_bridge(self, connect: str = "") -> BridgeOptions:
        """Return the options for a bridge.

        Args:
            connect: Endpoint of the router of ROS 2, or empty.
        """
        from zbot.bridge.bridge import BridgeOptions  # noqa: PLC0415 - not needed by `--help`
        from zbot.bridge.selection import Selection, patterns, read_rate  # noqa: PLC0415 - as above
        from zbot.names import validate_namespace  # noqa: PLC0415 - as above

        namespace = f"/{self.prefix.strip('/')}" if self.prefix.strip("/") else ""
        if namespace:
            validate_namespace(namespace)
        return BridgeOptions(
            ros_domain=_ros_domain(self.ros_domain),
            prefix=namespace,
            connect=connect,
            selection=Selection(
                topics=patterns(self.topics),
                services=patterns(self.services),
                actions=patterns(self.actions),
                excluded=patterns(self.exclude),
                parameters=self.parameters,
                rates=tuple(map(read_rate, self.rate or ())),
            ),
        )


ALL_ROUTES: Final = RouteOptions()


@app.callback()
def options() -> None:
    """Carry topics, services and actions between zbot and ROS 2."""


@app.command("dds", cls=BridgeCommand)
@with_option_groups
def dds(routes: RouteOptions = ALL_ROUTES) -> None:
    """Connect this domain with ROS 2 over DDS.

    It runs until Ctrl-C. It connects all topics, services and actions, except those that every node
    has, e.g. `/rosout`.
    """
    from zbot.bridge.bridge import run_dds  # noqa: PLC0415 - not needed by `--help`

    run_dds(routes.for_bridge())


@app.command("rmw_zenoh", cls=BridgeCommand)
@with_option_groups
def rmw_zenoh(
    connect: Annotated[
        str, typer.Option("--connect", help="Router of ROS 2: HOST, or tcp/HOST:7447")
    ] = "",
    routes: RouteOptions = ALL_ROUTES,
) -> None:
    """Connect this domain with ROS 2 over Zenoh.

    It runs until Ctrl-C. It connects all topics, services and actions, except those that every node
    has, e.g. `/rosout`.
    """
    from zbot.bridge.bridge import run_rmw_zenoh  # noqa: PLC0415 - not needed by `--help`

    run_rmw_zenoh(routes.for_bridge(_endpoint(connect)))


def _endpoint(address: str) -> str:
    """Return the Zenoh endpoint for an address: `robot`, `robot:7447` or `tcp/robot:7447`."""
    from zbot.classroom.hub.address import parse_address  # noqa: PLC0415 - not needed by `--help`

    return address if not address or "/" in address else parse_address(address).endpoint


def _ros_domain(given: int | None) -> int:
    from zbot.bridge.errors import BridgeError  # noqa: PLC0415 - not needed by `--help`

    if given is not None:
        return given
    text = os.environ.get("ROS_DOMAIN_ID", "").strip() or "0"
    number = whole_number(text)
    if number is None or number > 232:
        raise BridgeError(f"ROS_DOMAIN_ID is {text!r}: choose a number from 0 to 232")
    return number
