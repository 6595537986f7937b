"""File of a running program, which the program holds locked.

A file without a lock belongs to a program that was killed.
"""

from __future__ import annotations

import contextlib
import json
import os
import time
from typing import TYPE_CHECKING, Any

from zbot.package.user_folders import make_private
from zbot.text.json_reader import read_json_object
from zbot.transport import background_process

if TYPE_CHECKING:
    from pathlib import Path
    from typing import IO

_YOUNG_S = 5.0  # a younger file may not be locked yet


class ProgramFile:
    """File of this program. Only this user can read it.

    If the folder cannot be written, there is no file.

    Args:
        folder: The folder with the files of all programs.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / f"{os.getpid()}-{os.urandom(4).hex()}.json"
        self._file: IO[str] | None = None
        with contextlib.suppress(OSError):  # the folder is read-only
            self._file = _locked_file(self._path)

    def write(self, document: dict[str, Any]) -> None:
        """Replace the content of the file."""
        file = self._file
        if file is not None:
            # The disk may be full, or another thread may have closed the file.
            with contextlib.suppress(OSError, ValueError):
                file.seek(0)
                file.truncate()
                file.write(json.dumps(document))
                file.flush()

    def leave_to_parent(self) -> None:
        """In a forked child, let go of the file. Otherwise the child would keep it locked."""
        if self._file is not None:
            os.close(self._file.fileno())

    def close(self) -> None:
        """Remove the file."""
        file, self._file = self._file, None
        if file is not None:
            with contextlib.suppress(OSError):
                file.close()
                self._path.unlink(missing_ok=True)


def _locked_file(path: Path) -> IO[str]:
    make_private(path.parent)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
    file = os.fdopen(descriptor, "w+", encoding="utf-8")
    background_process.lock_soon(file)
    return file


def program_documents(folder: Path) -> list[dict[str, Any]]:
    """Return the documents of all running programs. Remove the files of killed programs."""
    try:
        paths = sorted(folder.glob("*.json"))
    except OSError:
        return []
    return [document for document in map(_read, paths) if document is not None]


def _read(path: Path) -> dict[str, Any] | None:
    try:
        with path.open("r+", encoding="utf-8") as file:
            is_over = background_process.lock(file)
            document: dict[str, Any] = read_json_object(file.read()) if not is_over else {}
        if is_over and time.time() - path.stat().st_mtime > _YOUNG_S:
            path.unlink()
    except (OSError, ValueError):
        return None  # the program ends or writes the file at this moment
    return None if is_over else document
