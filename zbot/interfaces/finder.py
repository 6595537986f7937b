"""`from std_msgs.msg import String`, without a package std_msgs on disk.

The modules of a real ROS 2 win. What is missing is filled in: whole packages, and `msg`, `srv`,
`action` in a real Python package that has no such module.

These finders see every import of every program, so they load what makes the modules,
`zbot.interfaces.importer`, for none but such a name: a command that lists topics does without, and
starts a fifth earlier.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.interfaces.kinds import KINDS

if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.machinery import ModuleSpec
    from types import ModuleType


#: They have modules named `action`, which are modules.
_PLAIN_PACKAGES = {"zbot", "zbot_cli"}
_JYTHONS = {"org", "java"}


def install_importer() -> None:
    """Make every known definition importable as in ROS 2; calling it again changes nothing."""
    if not any(isinstance(finder, _KindFinder) for finder in sys.meta_path):
        sys.meta_path.insert(0, _KindFinder())
        sys.meta_path.append(_PackageFinder())


class _KindFinder:
    """Finds `std_msgs.msg`, unless there is a real module.

    It stands first on `sys.meta_path`: to Python, a folder `my_package/msg` of .msg files is a
    namespace package, which would be found before anything at the end of the list is asked.
    """

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return a spec if a package has definitions of that kind, and no module of its own."""
        package, _, kind = fullname.partition(".")
        if kind not in KINDS or package in _PLAIN_PACKAGES:
            return None
        importer = _importer()
        if importer is None or not importer.has_package(package):
            return None
        others = (finder for finder in sys.meta_path if finder is not self)
        found = (finder.find_spec(fullname, path, target) for finder in others)
        if any(spec is not None and spec.origin is not None for spec in found):
            return None
        spec: ModuleSpec | None = importer.kind_spec(package, kind)
        return spec


class _PackageFinder:
    """Finds `std_msgs` and `std_msgs.msg._string`, last, when there is nothing real."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return a spec if the name stands for definitions that are known here."""
        del path, target
        package, _, inside = fullname.partition(".")
        if inside.partition(".")[0] not in KINDS if inside else _is_pythons(package):
            return None
        importer = _importer()
        if importer is None:
            return None
        spec: ModuleSpec | None
        spec = importer.spec_below(fullname) if inside else importer.package_spec(package)
        return spec


def _importer() -> Any:
    """Return the module that makes the others; `None` for what it looks for while it is loaded."""
    from zbot.interfaces import importer  # noqa: PLC0415 - see above

    return importer if hasattr(importer, "package_spec") else None


def _is_pythons(name: str) -> bool:
    # Python's library looks for the modules of other systems, such as `_wmi` and `msvcrt`, and
    # `copy` for Jython's.
    return name.startswith("_") or name in sys.stdlib_module_names or name in _JYTHONS
