"""Warnings about a program's own files that Python does not import.

`zbot_name_clash` warns about files that Python imports in place of a module of Python.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence


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
