"""Options and output that several verbs of `zbot bag` share."""

from __future__ import annotations

import sys
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from zbot.bag.reader import Reader
    from zbot.node.node import Node


class StorageId(str, Enum):
    """File formats of bags."""

    MCAP = "mcap"
    SQLITE3 = "sqlite3"


class LogLevel(str, Enum):
    """Levels of `--log-level`."""

    DEBUG = "debug"
    INFO = "info"
    WARN = "warn"
    ERROR = "error"
    FATAL = "fatal"


LogLevelOption = Annotated[
    LogLevel, typer.Option("--log-level", help="Print log lines of this level and above")
]
BagPath = Annotated[Path, typer.Argument(help="Folder of the bag, or one of its files")]
Storage = Annotated[
    StorageId | None, typer.Option("-s", "--storage", help="Format of the bag; default: any")
]


def open_bag(path: Path, storage: StorageId | None) -> Reader:
    """Open a bag. Print a warning if a part of it is missing.

    Raises:
        BagNotFoundError: There is no file or folder with this path.
        BagReadError: The path is not a bag, or the bag cannot be read.
        NoBagExtraError: The extra `bag` is not installed.
    """
    from zbot.bag.reader import Reader  # noqa: PLC0415 - not needed by --help

    bag = Reader(path, "" if storage is None else storage.value)
    if bag.damage:
        warn(f"only a part of the bag '{path}' can be read: {bag.damage}")
    if path.is_dir() and not bag.has_metadata_file:
        warn(f"'{path}' has no metadata.yaml: `zbot bag reindex {path}` writes it")
    return bag


def set_log_level(node: Node, level: str) -> None:
    """Print only log lines of a level and above."""
    from zbot.log import get_logging_severity_from_string  # noqa: PLC0415 - not needed by --help

    node.get_logger().set_level(get_logging_severity_from_string(level))


def types(words: Iterable[str] | None) -> list[str]:
    """Return the full names of message types: `std_msgs/msg/String` for `std_msgs/String`."""
    return [
        f"{parts[0]}/msg/{parts[1]}" if len(parts := word.split("/")) == 2 else word
        for word in words or ()
    ]


def refuse_together(options: Mapping[str, bool]) -> None:
    """Refuse options that exclude each other, as ros2 does.

    Args:
        options: Whether each option was given.

    Raises:
        typer.BadParameter: More than one of the options was given.
    """
    given = [name for name, is_given in options.items() if is_given]
    if len(given) > 1:
        raise typer.BadParameter(f"{' and '.join(given)} exclude each other: use one of them")


def warn(text: str) -> None:
    """Print a warning."""
    print(text, file=sys.stderr)


def without_storages(words: list[str]) -> Iterator[str]:
    """Yield the words without the storage in `-i BAG STORAGE`, because the format is detected."""
    storages = {storage.value for storage in StorageId}
    for index, word in enumerate(words):
        is_storage = index > 1 and word in storages and words[index - 2] in {"-i", "--input"}
        if not is_storage:
            yield word
