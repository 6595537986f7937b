"""Reader of the definitions in a folder or an archive from other people.

The reader never unpacks an archive into files. It reads only the texts of definitions, and uses
their paths in the archive only to group them. So a path in an archive cannot lead to a file of this
machine.
"""

from __future__ import annotations

import bz2
import gzip
import lzma
import os
import struct
import tarfile
import zipfile
import zlib
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, TypeAlias, TypeVar, cast

from zbot.errors import ZbotError
from zbot.interfaces.grammar import GrammarError, check_interface_name
from zbot.names import KINDS
from zbot.package.workspace import MANIFEST, SKIPPED, name_in_manifest

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

MAX_ARCHIVE = 64 * 2**20  #: bytes of an archive
MAX_UNPACKED = 256 * 2**20  #: bytes that are unpacked from a tar archive
#: An archive may unpack to a megabyte, and to 50 bytes for each of its bytes. Texts usually have
#: 10. Without this limit, an archive of 800 bytes can have 30,000 empty files.
_SMALL, _MOST_FOR_EACH_BYTE = 2**20, 50
_MAX_HEADERS = 100  #: for all entries of a tar archive. Each entry copies them
MAX_ENTRIES = 100_000  #: files and folders in an archive or a folder
MAX_FILE = 256 * 2**10  #: bytes of a definition
MAX_TOTAL = 16 * 2**20  #: bytes of all definitions and manifests together

_T = TypeVar("_T")
#: The parts of a path, and a function that reads the file.
_Entry: TypeAlias = "tuple[tuple[str, ...], Callable[[], bytes]]"

_COMPRESSIONS: tuple[tuple[bytes, Callable[[IO[bytes]], Any]], ...] = (
    (b"\x1f\x8b", gzip.open),
    (b"BZh", bz2.open),
    (b"\xfd7zXZ\x00", lzma.open),
)
#: Exceptions that the standard library raises for a damaged archive.
_DAMAGED = (
    zipfile.BadZipFile,
    tarfile.TarError,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    OSError,
    EOFError,
    ValueError,
    IndexError,
    OverflowError,
    RuntimeError,  # also for an archive with a password
    NotImplementedError,
)


class DefinitionSourceError(ZbotError, ValueError):
    """A folder or an archive with definitions cannot be read."""

    def __init__(self, source: Path, reason: str) -> None:
        self.source, self.reason = source, reason
        super().__init__(f"cannot read definitions from {source}: {reason}")


@dataclass
class FoundPackage:
    """A package with definitions in a folder or an archive."""

    name: str
    place: str  #: the package's folder in the source
    texts: dict[str, str] = field(default_factory=dict)  #: e.g. `msg/Num.msg` -> the text


def collect(source: Path) -> list[FoundPackage]:
    """Return the packages with definitions in a folder or an archive, sorted by name.

    Args:
        source: A folder at any level above the packages, or a zip, whl or tar file.

    Raises:
        DefinitionSourceError: The source cannot be read, is too large, has no definitions, has two
            packages of the same name, or has definitions in a folder that cannot be a package.
    """
    try:
        entries = _folder_entries(source) if source.is_dir() else _archive_entries(source)
        found = _grouped(source, entries)
    except DefinitionSourceError:
        raise
    except _DAMAGED as error:
        reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
        raise DefinitionSourceError(source, str(reason)) from error
    if not found:
        raise DefinitionSourceError(source, "there are no .msg, .srv and .action files in it")
    return found


def _grouped(source: Path, entries: Iterable[_Entry]) -> list[FoundPackage]:
    texts: dict[tuple[str, ...], dict[str, str]] = {}
    manifests: dict[tuple[str, ...], str] = {}
    total = 0
    for parts, read in entries:
        is_manifest = parts[-1:] == (MANIFEST,)
        if not is_manifest and not _is_definition(parts):
            continue
        content = read()
        total += len(content)
        if total > MAX_TOTAL:
            raise DefinitionSourceError(source, f"its definitions exceed {MAX_TOTAL} bytes")
        # Comments in the definitions may have another encoding than UTF-8.
        text = content.decode(errors="replace")
        if is_manifest:
            manifests[parts[:-1]] = text
        else:
            texts.setdefault(parts[:-2], {})["/".join(parts[-2:])] = text
    found: dict[str, FoundPackage] = {}
    for parts, inside in sorted(texts.items()):
        name = name_in_manifest(manifests.get(parts, "")) or (parts or (_stem(source),))[-1]
        package = FoundPackage(name, "/".join(parts) or ".", inside)
        _check(source, package, found.get(name))
        found[name] = package
    return sorted(found.values(), key=lambda package: package.name)


def _is_definition(parts: tuple[str, ...]) -> bool:
    kind, name = parts[-2:] if len(parts) > 1 else ("", "")
    return kind in KINDS and name.endswith(f".{kind}") and not name.startswith(".")


def _check(source: Path, package: FoundPackage, other: FoundPackage | None) -> None:
    if other is not None:
        places = f"{other.place!r} and {package.place!r}"
        reason = f"{package.name!r} is the name of two packages, in {places}: give one of the two"
        raise DefinitionSourceError(source, reason)
    for path in package.texts:
        kind, _, file = path.partition("/")
        try:
            check_interface_name(f"{package.name}/{kind}/{file.rpartition('.')[0]}")
        except GrammarError as error:
            where = f"{package.place}/{path}"
            raise DefinitionSourceError(source, f"{where!r}: {error}") from None


def _stem(source: Path) -> str:
    return source.resolve().name.partition(".")[0]


def _folder_entries(source: Path) -> Iterator[_Entry]:
    for folder, below, names in _counted(source, os.walk(source)):
        below[:] = sorted(
            child for child in below if not child.startswith(".") and child not in SKIPPED
        )
        parts = Path(folder).relative_to(source).parts
        for name in _counted(source, sorted(names)):
            yield (*parts, name), partial(_file_content, source, Path(folder, name))


def _file_content(source: Path, path: Path) -> bytes:
    if not path.is_file():  # a pipe or a device would never end
        raise DefinitionSourceError(source, f"{path.name!r} is not a file")
    with path.open("rb") as file:
        return _content(source, path.name, file)


def _content(source: Path, name: str, file: IO[bytes] | None) -> bytes:
    content = file.read(MAX_FILE + 1) if file else b""
    if len(content) > MAX_FILE:
        raise DefinitionSourceError(source, f"{name!r} is larger than {MAX_FILE} bytes")
    return content


def _archive_entries(source: Path) -> Iterator[_Entry]:
    if source.stat().st_size > MAX_ARCHIVE:
        reason = f"it is larger than {MAX_ARCHIVE} bytes: unpack it and give the package's folder"
        raise DefinitionSourceError(source, reason)
    return _zip_entries(source) if zipfile.is_zipfile(source) else _tar_entries(source)


def _zip_entries(source: Path) -> Iterator[_Entry]:
    with zipfile.ZipFile(source) as archive:
        for entry in _counted(source, archive.infolist()):
            if not entry.is_dir():
                yield _parts(entry.filename), partial(_zip_content, source, archive, entry)


def _zip_content(source: Path, archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> bytes:
    with archive.open(entry) as file:
        return _content(source, entry.filename, file)


def _tar_entries(source: Path) -> Iterator[_Entry]:
    with _unpacked(source) as file, tarfile.open(fileobj=file, mode="r|") as archive:
        for entry in _counted(source, archive):
            if len(archive.pax_headers) > _MAX_HEADERS:
                reason = f"it has more than {_MAX_HEADERS} headers for all its files"
                raise DefinitionSourceError(source, reason)
            if entry.isreg():  # links are not followed
                yield _parts(entry.name), partial(_tar_content, source, archive, entry)


def _tar_content(source: Path, archive: tarfile.TarFile, entry: tarfile.TarInfo) -> bytes:
    return _content(source, entry.name, archive.extractfile(entry))


@contextmanager
def _unpacked(source: Path) -> Iterator[IO[bytes]]:
    """Open a tar archive. Reading more bytes of it than allowed raises an error."""
    with source.open("rb") as plain:
        start = plain.read(8)
        plain.seek(0)
        unpack = next((opener for magic, opener in _COMPRESSIONS if start.startswith(magic)), None)
        with unpack(plain) if unpack else plain as file:
            allowed = _SMALL + _MOST_FOR_EACH_BYTE * source.stat().st_size
            limited = _LimitedStream(source, file, min(MAX_UNPACKED, allowed))
            yield cast("IO[bytes]", limited)


def _parts(name: str) -> tuple[str, ...]:
    return tuple(part for part in name.split("/") if part not in {"", "."})


def _counted(source: Path, entries: Iterable[_T]) -> Iterator[_T]:
    for count, entry in enumerate(entries):
        if count >= MAX_ENTRIES:
            raise DefinitionSourceError(source, f"it has more than {MAX_ENTRIES} files and folders")
        yield entry


class _LimitedStream:
    """Stream that raises an error when too many bytes were read from it."""

    def __init__(self, source: Path, file: IO[bytes], most: int) -> None:
        self._source, self._file, self._most, self._left = source, file, most, most

    def read(self, size: int) -> bytes:
        """Return up to `size` bytes."""
        content = self._file.read(size)
        self._left -= len(content)
        if self._left < 0:
            reason = f"its content is larger than {self._most} bytes"
            raise DefinitionSourceError(self._source, reason)
        return content
