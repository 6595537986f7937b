"""Problem that a check found in a package."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, order=True)
class Problem:
    """Problem in a file of a package."""

    path: Path
    line: int  #: counted from 1; 0 for the whole file
    text: str
    is_error: bool = True  #: `False` if the package works in zbot, but may fail in ROS 2

    def __str__(self) -> str:
        shown = shown_path(self.path)
        where = f"{shown}:{self.line}" if self.line else str(shown)
        return f"{where}: {'' if self.is_error else 'warning: '}{self.text}"


def shown_path(path: Path) -> Path:
    """Return a path inside the current folder as a relative path, and other paths unchanged."""
    try:
        return path.relative_to(Path.cwd())
    except (ValueError, FileNotFoundError):  # not inside, or the current folder is deleted
        return path
