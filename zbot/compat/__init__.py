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
    from collections.abc import Iterable, Sequence
    from types import ModuleType

_PACKAGES = str(Path(__file__).parent / "packages")
_preferred: set[str] = set()


class _NameFinder:
    """Finds `rclpy` and its like in `packages/`, unless they are installed."""

    @staticmethod
    def find_spec(
        fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the spec of a top-level package; Python finds its submodules by itself."""
        if path is not None:
            return None
        own = PathFinder.find_spec(fullname, [_PACKAGES], target)
        if own is None or (fullname not in _preferred and _is_installed(fullname)):
            return None
        return own


def _is_installed(name: str) -> bool:
    """Return whether there is a real package: a mere folder, such as `launch`, is none."""
    for finder in sys.meta_path:
        spec = None if finder is _NameFinder else finder.find_spec(name, None)
        if spec is not None and spec.origin is not None:
            return True
    return False


def install_names(preferred: Iterable[str] = ()) -> None:
    """Make ROS 2's names importable; calling it again changes nothing else.

    Args:
        preferred: Names that mean zbot even where the real packages are installed.
    """
    _preferred.update(preferred)
    if _NameFinder not in sys.meta_path:
        # First, for Python would take any folder of that name for the package.
        sys.meta_path.insert(0, _NameFinder)


install_names()
