"""Verbs of `zbot bag`: record topics, look into recordings and play them."""

from __future__ import annotations

import contextlib
from enum import Enum
from pathlib import Path
from typing import Annotated, Any

import typer

from zbot.errors import counted
from zbot_cli.commands.bag.options import BagPath, Storage, open_bag, warn, without_storages
from zbot_cli.commands.bag.play import BurstCommand, PlayCommand, burst, play
from zbot_cli.commands.bag.record import RecordCommand, record
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.listing import AsJson, new_app, print_json

app = new_app("Record topics, and play recordings")
app.command("record", cls=RecordCommand)(record)
app.command("play", cls=PlayCommand)(play)
app.command("burst", cls=BurstCommand)(burst)


class SortKey(str, Enum):
    """Orders of the topics in `zbot bag info`."""

    NAME = "name"
    TYPE = "type"
    COUNT = "count"
    SERIALIZATION_FORMAT = "serialization_format"


@app.command("info")
def info(
    bag_path: BagPath,
    storage: Storage = None,
    topic_name: Annotated[
        bool, typer.Option("-t", "--topic-name", help="Print only the names of the topics")
    ] = False,
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Add sizes, and calls of services")
    ] = False,
    sort: Annotated[SortKey, typer.Option("--sort", help="Order of the topics")] = SortKey.NAME,
    as_json: AsJson = False,
) -> None:
    """Show what is in a bag."""
    from zbot.bag.description import contributions, description, topic_names  # noqa: PLC0415 - only here
    from zbot.bag.write_queue import LOST_KEY  # noqa: PLC0415 - as above

    if topic_name and verbose:
        warn("You have set both the '-t' and '-v' parameters. The '-t' parameter will be ignored.")
    with open_bag(bag_path, storage) as bag:
        lost = bag.metadata.custom_data.get(LOST_KEY)
        if lost:
            warn(f"messages were lost in this recording: {lost}")
        if as_json:
            from zbot.bag.metadata import metadata_values  # noqa: PLC0415 - only for JSON

            print_json(metadata_values(bag.metadata) | {"bag_size": bag.metadata.bag_size})
        elif topic_name and not verbose:
            print("\n".join(topic_names(bag.metadata, sort.value)))
        elif verbose:
            sizes, calls = contributions(bag)
            print(description(bag.metadata, sort=sort.value, sizes=sizes, calls=calls), end="")
        else:
            print(description(bag.metadata, sort=sort.value), end="")


class PluginType(str, Enum):
    """Kinds of plugins of rosbag2."""

    STORAGE = "storage"
    CONVERTER = "converter"
    COMPRESSOR = "compressor"
    DECOMPRESSOR = "decompressor"


#: Names and descriptions of zbot's plugins, by kind.
_PLUGINS = {
    PluginType.STORAGE: {"mcap": "MCAP files", "sqlite3": "sqlite3 files"},
    PluginType.CONVERTER: {},
    PluginType.COMPRESSOR: {"zstd": "Zstandard, for whole files"},
    PluginType.DECOMPRESSOR: {"zstd": "Zstandard, for whole files and messages"},
}


@app.command("reindex")
def reindex(
    bag_path: Annotated[Path, typer.Argument(help="Folder of the bag")], storage: Storage = None
) -> None:
    """Write the metadata of a bag again."""
    from zbot.bag.conversion import reindex as write_metadata  # noqa: PLC0415 - needed only here

    metadata = write_metadata(bag_path)
    print(f"metadata.yaml of {bag_path}: {counted(metadata.message_count, 'message')}")


class _ConvertCommand(ManyValuesCommand):
    """Parser of `-i BAG [STORAGE]`."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Leave the storage of an input out, because the format is detected."""
        return super().parse_args(ctx, list(without_storages(args)))


@app.command("convert", cls=_ConvertCommand)
def convert(
    inputs: Annotated[
        list[Path], typer.Option("-i", "--input", help="Bag to read; may be given several times")
    ],
    output_options: Annotated[
        Path, typer.Option("-o", "--output-options", help="YAML file with output_bags")
    ],
) -> None:
    """Write new bags from other bags."""
    from zbot.bag.conversion import convert as write_bag  # noqa: PLC0415 - needed only here
    from zbot.bag.conversion import read_outputs  # noqa: PLC0415 - as above

    outputs = read_outputs(output_options)
    with contextlib.ExitStack() as stack:
        bags = [stack.enter_context(open_bag(path, None)) for path in inputs]
        for output in outputs:
            print(f"{output.storage.uri}: {counted(write_bag(bags, output), 'message')}")


@app.command("list")
def list_plugins(
    plugin_type: Annotated[PluginType, typer.Argument(help="Kind of plugin")],
    verbose: Annotated[bool, typer.Option("-v", "--verbose", help="Add a description")] = False,
    as_json: AsJson = False,
) -> None:
    """List the formats that zbot has."""
    if as_json:
        found = _PLUGINS[plugin_type].items()
        print_json([{"name": name, "description": text} for name, text in found])
        return
    if verbose:
        print(f"available {plugin_type.value} plugins are:")
    for name, text in _PLUGINS[plugin_type].items():
        print(f"name: {name}\n\t{text}" if verbose else name)
