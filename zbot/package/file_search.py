"""Search for files by pattern, with a limit for the number of folder entries that are read."""

from __future__ import annotations

import fnmatch
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

_MAX_ENTRIES = 100_000
_FOLDER_ENTRIES = 10  #: a folder that is opened counts as this many entries
_MAX_DEPTH = 30
_MAX_PART = 1000  #: characters of a pattern between two slashes
_MAGIC = re.compile(r"[*?[]")


class SearchLimitError(Exception):
    """A search read too many folder entries. The caller adds the file that has the pattern."""

    def __init__(self) -> None:
        super().__init__(f"its patterns search more than {_MAX_ENTRIES} files")


class FileSearch:
    """Searches for files. All searches of one object together have one limit.

    Recursive searches do not follow symbolic links, which may form a circle.

    Args:
        folder: The folder in which relative patterns are searched.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._left = _MAX_ENTRIES

    def matching(self, pattern: str, *, recursive: bool = False) -> list[str]:
        """Return the files and folders that match a pattern, sorted.

        The paths are relative if the pattern is relative.

        Args:
            pattern: Pattern as for `glob.glob`.
            recursive: Whether `**` means any number of folders.

        Raises:
            SearchLimitError: The searches read too many folder entries.
        """
        start, *parts = pattern.replace(os.sep, "/").split("/")
        begin = "/" if pattern.startswith("/") else ""
        found = [begin]
        for part in [*([start] if start else []), *parts]:
            found = list(dict.fromkeys(self._step(found, part, recursive=recursive)))
        return sorted(path for path in found if path)

    def below(self, folder: Path) -> list[Path]:
        """Return all files below a folder, sorted.

        Raises:
            SearchLimitError: The searches read too many folder entries.
        """
        return sorted(Path(path) for path in self._below(str(folder), 0) if os.path.isfile(path))  # noqa: PTH113

    def _step(self, found: list[str], part: str, *, recursive: bool) -> Iterator[str]:
        for path in found:
            if part == "**" and recursive:
                yield path
                yield from self._below(path, 0)
            elif len(part) > _MAX_PART:
                return  # no file has such a name, and `fnmatch` would need very long
            elif _MAGIC.search(part):
                names = fnmatch.filter(self._names(path), part)
                yield from (os.path.join(path, name) for name in names if _is_shown(name, part))  # noqa: PTH118
            elif os.path.lexists(os.path.join(self._folder, path, part)):  # noqa: PTH118
                self._count(1)
                yield os.path.join(path, part)  # noqa: PTH118

    def _below(self, base: str, depth: int) -> Iterator[str]:
        for name in self._names(base):
            path = os.path.join(base, name)  # noqa: PTH118
            if not name.startswith("."):
                yield path
                full = self._folder / path
                if depth < _MAX_DEPTH and not full.is_symlink():
                    yield from self._below(path, depth + 1)

    def _names(self, base: str) -> list[str]:
        self._count(_FOLDER_ENTRIES)
        try:
            with os.scandir(self._folder / base) as entries:
                names = []
                for entry in entries:
                    self._count(1)
                    names.append(entry.name)
                return names
        except (OSError, ValueError):  # not a folder, or not a name
            return []

    def _count(self, entries: int) -> None:
        self._left -= entries
        if self._left < 0:
            raise SearchLimitError


def _is_shown(name: str, part: str) -> bool:
    return part.startswith(".") or not name.startswith(".")
