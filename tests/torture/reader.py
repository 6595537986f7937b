"""Reader of foreign bytes or text, as the torture test sees it, and its input as text or file."""

from __future__ import annotations

import importlib
import json
import shutil
import tempfile
from dataclasses import dataclass
from multiprocessing.util import Finalize
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


@dataclass(frozen=True)
class Reader:
    """A reader and what it may do."""

    name: str
    modules: tuple[str, ...]  #: the modules that contain it, e.g. `zbot.wire.messagepack.codec`
    call: Callable[[bytes], object]
    errors: tuple[type[Exception], ...]  #: the named errors with which it may refuse an input
    seeds: tuple[bytes, ...]  #: valid inputs, and inputs that once were a problem
    limit_s: float = 1.0  #: the longest processor time for one input, see `allowed`


#: The modules with lists of readers. Some of them import simulators and servers.
_LISTS = (
    *("network_readers", "text_readers", "class_readers", "package_readers", "bag_readers"),
    *("web_readers", "view_readers", "simulation_readers", "device_readers"),
)


def readers() -> Iterator[Reader]:
    """Yield all readers. A module is imported when the readers before it were not enough."""
    for name in _LISTS:
        yield from getattr(importlib.import_module(f"tests.torture.{name}"), name.upper())


def temporary_folder(prefix: str) -> Path:
    """Return a new folder, which is removed when this process ends."""
    folder = Path(tempfile.mkdtemp(prefix=prefix))
    # `atexit` does not run in the processes of multiprocessing, and this does.
    Finalize(None, shutil.rmtree, (folder, True), exitpriority=0)
    return folder


#: The folder of the files that readers read.
FOLDER = temporary_folder("zbot-torture-")


def file_with(name: str, data: bytes) -> Path:
    path = FOLDER / name.partition(".")[0] / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(data)
    return path


def text_of(data: bytes) -> str:
    return data.decode(errors="surrogateescape")  # a terminal and a file may have any bytes


def json_bytes(value: object) -> bytes:
    return json.dumps(value).encode()
