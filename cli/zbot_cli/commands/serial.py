"""`zbot serial`: makes topics from the lines that a board prints on a serial port."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar

import typer

from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.listing import new_app

if TYPE_CHECKING:
    from zbot.bridge.devices.serial.board import BoardOptions

app = new_app("Connect a board on a USB cable", has_verbs=False)


class SerialCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset({"--type", "--to"})


@app.command(cls=SerialCommand)
def serial(
    port: Annotated[
        str, typer.Argument(help="/dev/ttyACM0 or COM3; found if only one board is on USB")
    ] = "",
    list_ports: Annotated[bool, typer.Option("--list", help="List the ports and end")] = False,
    baud: Annotated[int, typer.Option("--baud", min=50, help="Bits per second")] = 115200,
    topic: Annotated[
        str, typer.Option("--topic", help="Topic of lines that are only a value: 23.5")
    ] = "",
    names: Annotated[
        str, typer.Option("--names", help="Topics of lines with only numbers: x,y,z")
    ] = "",
    types: Annotated[
        list[str] | None,
        typer.Option("--type", help="Type of a topic: temperature:Float64, /imu:sensor_msgs/Imu"),
    ] = None,
    types_file: Annotated[
        str, typer.Option("--types", help="YAML file with a line 'TOPIC: TYPE' for each topic")
    ] = "",
    to: Annotated[
        list[str] | None,
        typer.Option("--to", help="Topic that the board gets as lines: /led:std_msgs/msg/Bool"),
    ] = None,
    name: Annotated[str, typer.Option("--name", help="Name of the node")] = "",
    namespace: Annotated[
        str, typer.Option("--namespace", help="Namespace of the node and its topics: /left")
    ] = "",
    sketch: Annotated[
        str,
        typer.Option(
            "--sketch", help="Print a program for a board: arduino, micropython, circuitpython"
        ),
    ] = "",
) -> None:
    """Connect a board on a USB cable.

    The board prints lines such as `temperature: 23.5`. Each name is a topic. It runs until Ctrl-C.
    """
    if sketch:
        from zbot.bridge.devices.serial.sketch import sketch_for  # noqa: PLC0415 - not needed by `--help`

        print(sketch_for(sketch), end="")
    elif list_ports:
        _list()
    else:
        from zbot.bridge.devices.serial.board import BoardOptions  # noqa: PLC0415 - not needed by `--help`
        from zbot.bridge.devices.topic_subscriptions import Wanted  # noqa: PLC0415 - as above
        from zbot.bridge.devices.topic_type import TypeTable  # noqa: PLC0415 - as above

        given = BoardOptions(
            baud=baud,
            topic=topic,
            names=tuple(filter(None, (part.strip() for part in names.split(",")))),
            types=TypeTable.read(types or (), types_file),
            to_board=tuple(map(Wanted.parse, to or ())),
        )
        if topic and given.names:
            raise CommandError("use --topic or --names, not both")
        _run(port, name, namespace, given)


def _list() -> None:
    from zbot.bridge.devices.serial.port import all_ports  # noqa: PLC0415 - not needed by `--help`

    found = all_ports()
    if not found:
        raise CommandError("no serial port is on this machine", hint="plug in a board")
    width = max(len(port.device) for port in found)
    for port in found:
        print(f"{port.device:<{width}}  {port.description}")


def _run(port: str, name: str, namespace: str, options: BoardOptions) -> None:
    from zbot.bridge.devices.device_node import device_node, node_name  # noqa: PLC0415 - not needed by `--help`
    from zbot.bridge.devices.serial.board import Board  # noqa: PLC0415 - as above
    from zbot.bridge.devices.serial.port import open_port, read_port  # noqa: PLC0415 - as above

    info, is_found = read_port(port)
    opened = open_port(info.device, options.baud)
    with device_node(name or node_name("board", info.device), namespace) as node:
        Board(node, info, options, is_found=is_found).run(opened)
