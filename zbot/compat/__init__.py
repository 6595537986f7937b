"""ROS 2's own import names: after `import zbot.compat`, `import rclpy` is zbot.

`zbot run` and `zbot launch` import this before the program. Each folder of `packages/` stands for
one import name and only re-exports what zbot has; where the real package is installed, it wins.
"""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import ModuleType

_PACKAGES = str(Path(__file__).parent / "packages")


class _NameFinder:
    """Finds `rclpy` and its like in `packages/`, when nothing before it did."""

    @staticmethod
    def find_spec(
        fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the spec of a top-level package; Python finds its submodules by itself."""
        return PathFinder.find_spec(fullname, [_PACKAGES], target) if path is None else None


def install_names() -> None:
    """Make ROS 2's names importable; calling it again changes nothing."""
    if _NameFinder not in sys.meta_path:
        sys.meta_path.append(_NameFinder)


install_names()
