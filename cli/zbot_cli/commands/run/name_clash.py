"""Warnings about a program's own files that have the name of a module of Python.

Python searches the program's folder first. So a file `random.py` replaces the module `random`, also
for other modules. These modules then fail in places that the student does not know.
"""

from __future__ import annotations

import re
import sys
from importlib.machinery import FrozenImporter
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence


class NameClashWarner:
    """Finder for `sys.meta_path` that only warns if a file replaces a module of Python.

    Args:
        folders: The folders that Python searches first.
    """

    def __init__(self, folders: Sequence[str]) -> None:
        self._folders = folders

    def find_spec(self, name: str, path: Sequence[str] | None = None, _: object = None) -> None:
        """Warn if a name is a module of Python and a file of the folders replaces it."""
        if path is not None or name not in sys.stdlib_module_names:
            return
        # Python searches for these modules before it searches folders.
        if name in sys.builtin_module_names or FrozenImporter.find_spec(name) is not None:
            return
        file = _file_of(name, self._folders)
        if file is not None:
            _warn(f"{file} hides Python's module {name}: rename the file")


def warn_of_unused_files(source: bytes, folder: str) -> None:
    """Warn about files in a script's folder that the script tries to import, but cannot import.

    The script gets Python's own module of the same name, which is already imported.

    Args:
        source: The text of the script.
        folder: The folder of the script.
    """
    imported = re.findall(rb"^[ \t]*(?:import|from)[ \t]+(\w+)", source, re.MULTILINE)
    for name in sorted({one.decode() for one in imported} & sys.stdlib_module_names):
        file = _file_of(name, [folder]) if name in sys.modules else None
        if file is not None:
            reason = f"because Python uses its own module {name}"
            _warn(f"{file} is not imported, {reason}: rename the file")


def _file_of(name: str, folders: Sequence[str]) -> Path | None:
    places = (
        Path(folder) / one for folder in folders for one in (f"{name}.py", f"{name}/__init__.py")
    )
    return next((place for place in places if place.is_file()), None)


def _warn(text: str) -> None:
    print(text, file=sys.stderr)
