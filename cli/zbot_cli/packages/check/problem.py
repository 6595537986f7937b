"""One thing that is wrong with a package."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, order=True)
class Problem:
    """What is wrong, and where."""

    path: Path
    line: int  #: counted from 1; 0 if it is the whole file
    text: str
    is_error: bool = True  #: False: it works here, whether or not it would in ROS 2

    def __str__(self) -> str:
        try:
            shown = self.path.relative_to(Path.cwd())
        except (ValueError, FileNotFoundError):  # elsewhere, or there is no current folder
            shown = self.path
        where = f"{shown}:{self.line}" if self.line else str(shown)
        return f"{where}: {'' if self.is_error else 'warning: '}{self.text}"
