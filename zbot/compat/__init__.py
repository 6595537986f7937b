"""ROS 2's import names. After `import zbot.compat`, `import rclpy` imports zbot.

`zbot run` and `zbot launch` import this package before they run the program. In other programs, the
module `zbot_ros2_names` imports this package at the first import of one of ROS 2's names. Each
folder in `packages/` is a package with one of these names, and only imports classes and functions
of zbot. `table.py` says where these are. If a real package of ROS 2 is installed, Python imports
the real package instead, except if zbot is preferred (`import_finder`).

The sources of such a package in a workspace are not imported, because most of them have parts in
C++ that zbot cannot build: `tf2_ros` imports the C++ of `tf2_py`.
"""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.compat.missing_name import explain_missing_name
from zbot.package import import_finder, python_finder

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from types import ModuleType

_PACKAGES = str(Path(__file__).parent / "packages")
_preferred: set[str] = set()


def _find_package(
    fullname: str, path: Sequence[str] | None, target: ModuleType | None
) -> ModuleSpec | None:
    """Return the spec of a top-level package. Python itself finds the package's submodules."""
    if path is not None:
        return None
    own = PathFinder.find_spec(fullname, [_PACKAGES], target)
    is_preferred = fullname in _preferred or import_finder.prefers_zbot()
    return own if own and (is_preferred or not _is_installed(fullname)) else None


def _is_installed(name: str) -> bool:
    return import_finder.is_installed(name, among=python_finder.paths_outside_workspace())


def install_names(preferred: Iterable[str] = ()) -> None:
    """Make ROS 2's names importable. This function may be called again.

    Args:
        preferred: Names that import zbot even if the real packages are installed.
    """
    _preferred.update(preferred)
    import_finder.add("ROS 2's names", _find_package)
    python_finder.install()
    import_finder.explain(explain_missing_name)
    started = sys.modules.get("zbot_ros2_names")
    if started is not None:
        started.remove()


install_names()
