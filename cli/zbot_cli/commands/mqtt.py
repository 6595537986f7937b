"""`zbot mqtt`: makes topics from the topics of an MQTT broker, and back."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import Annotated, ClassVar

import typer

from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.listing import new_app

app = new_app("Connect an MQTT broker of a smart home", has_verbs=False)
_PASSWORD = "ZBOT_MQTT_PASSWORD"  # noqa: S105 - the name of a variable


class MqttCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset({"--from", "--type", "--to"})


@app.command(cls=MqttCommand)
def mqtt(
    broker: Annotated[
        str, typer.Argument(help="HOST, HOST:PORT or mqtts://USER@HOST:PORT")
    ] = "localhost",
    filters: Annotated[
        list[str] | None,
        typer.Option("--from", help="Topics of the broker: 'home/#', 'tele/+/SENSOR'"),
    ] = None,
    to: Annotated[
        list[str] | None,
        typer.Option("--to", help="Topics that the broker gets: /led, '/robot/*', /led=cmnd/POWER"),
    ] = None,
    types: Annotated[
        list[str] | None,
        typer.Option("--type", help="Type of a topic: /home/temperature:Float64, '/imu/*:Imu'"),
    ] = None,
    types_file: Annotated[
        str, typer.Option("--types", help="YAML file with a line 'TOPIC: TYPE' for each topic")
    ] = "",
    prefix: Annotated[
        str, typer.Option("--prefix", help="Namespace for the topics of the broker: /house")
    ] = "",
    qos: Annotated[
        int,
        typer.Option(
            "--qos", min=0, max=2, help="MQTT's quality of what is sent; 1 waits for a lost broker"
        ),
    ] = 0,
    user: Annotated[
        str, typer.Option("--user", help="User; the password is in ZBOT_MQTT_PASSWORD")
    ] = "",
    tls: Annotated[bool, typer.Option("--tls", help="Encrypt the connection")] = False,
    ca: Annotated[
        str, typer.Option("--ca", help="File with the certificate of the broker's authority")
    ] = "",
    certificate: Annotated[
        str, typer.Option("--cert", help="File with a certificate of this client")
    ] = "",
    key: Annotated[str, typer.Option("--key", help="File with the key of --cert")] = "",
    name: Annotated[str, typer.Option("--name", help="Name of the node")] = "mqtt",
) -> None:
    """Connect an MQTT broker of a smart home.

    The topic `home/temperature` of the broker is `/home/temperature` in zbot. It runs until Ctrl-C.
    """
    from zbot.bridge.devices.device_node import device_node  # noqa: PLC0415 - not needed by `--help`
    from zbot.bridge.devices.mqtt.address import parse_address  # noqa: PLC0415 - as above
    from zbot.bridge.devices.mqtt.broker import Broker, BrokerOptions  # noqa: PLC0415 - as above
    from zbot.bridge.devices.topic_subscriptions import Wanted  # noqa: PLC0415 - as above
    from zbot.bridge.devices.topic_type import TypeTable  # noqa: PLC0415 - as above

    if not filters and not to:
        raise CommandError(
            "there is nothing to do: name topics of the broker or of zbot",
            hint="for example: zbot mqtt --from 'home/#' --to /led",
        )
    address = parse_address(broker, has_tls=tls or bool(ca))
    address = replace(
        address,
        user=user or address.user,
        password=os.environ.get(_PASSWORD, "") or address.password,
        ca_file=ca,
        certificate=certificate,
        key=key,
    )
    options = BrokerOptions(
        filters=tuple(filters or ()),
        to_broker=tuple(map(Wanted.parse, to or ())),
        types=TypeTable.read(types or (), types_file),
        qos=qos,
        prefix=prefix,
    )
    with device_node(name, "") as node:
        Broker(node, address, options).run()
