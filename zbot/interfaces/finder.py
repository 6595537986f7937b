"""Finders for `sys.meta_path` that make `from std_msgs.msg import String` work.

The modules of an installed ROS 2 have priority. The finders add missing packages. In existing
Python packages, they add missing modules `msg`, `srv` and `action`.

Python asks these finders for every import. `zbot.interfaces.importer` makes the modules. The
finders load `importer` only to find such a module, so `zbot topic list` starts 20 % faster.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.interfaces.kinds import KINDS

if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.machinery import ModuleSpec
    from types import ModuleType


#: Packages whose modules named `action` are real modules.
_PLAIN_PACKAGES = {"zbot", "zbot_cli"}
#: Endings of names that ROS 2 gives to packages of definitions.
_ENDINGS = ("_msgs", "_srvs", "_actions", "_interfaces", "_msg", "_srv", "_interface")
_JYTHONS = {"org", "java"}


def install_importer() -> None:
    """Make every known definition importable as in ROS 2. A second call has no effect."""
    if not any(isinstance(finder, _KindFinder) for finder in sys.meta_path):
        sys.meta_path.insert(0, _KindFinder())
        sys.meta_path.append(_PackageFinder())


class _KindFinder:
    """Finder of `std_msgs.msg`, if there is no real module.

    This finder is the first on `sys.meta_path`. For Python, a folder `my_package/msg` of .msg files
    is a namespace package. Python's own finder finds it, so Python does not ask a later finder.
    """

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return a spec if a package has definitions of this kind but no real module for them."""
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
    """Finder of `std_msgs` and `std_msgs.msg._string`, if no other finder finds a module."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return a spec if the name belongs to known definitions.

        Raises:
            InterfaceImportError: A package of definitions has no such module.
            MissingPackageError: A program imports a package that does not exist, and the name has
                the form of a package of definitions, e.g. `my_msgs`.
        """
        package, _, inside = fullname.partition(".")
        if _is_pythons(package):
            return None
        importer = _importer()
        if importer is None:
            return None
        spec: ModuleSpec | None
        if inside:
            spec = importer.submodule_spec(fullname) if inside.partition(".")[0] in KINDS else None
            if spec is None and is_import_statement():
                error = importer.missing_module(package, inside)
                if error is not None:
                    raise error
            return spec
        spec = importer.package_spec(package)
        if spec is None and package.endswith(_ENDINGS) and is_import_statement():
            later = sys.meta_path[sys.meta_path.index(self) + 1 :]
            if not any(finder.find_spec(fullname, path, target) for finder in later):
                raise importer.missing_package(package)
        return spec


def _importer() -> Any:
    """Return the module `importer`, or `None` while Python is still importing it."""
    from zbot.interfaces import importer  # noqa: PLC0415 - see the module's docstring

    return importer if hasattr(importer, "package_spec") else None


def is_import_statement() -> bool:
    """Return whether Python imports a module. `importlib.util.find_spec` only asks for one."""
    # The callers: the finder's find_spec, importlib's _find_spec, and the function that called it.
    return sys._getframe(3).f_code.co_name == "_find_and_load_unlocked"  # noqa: SLF001 - documented


def _is_pythons(name: str) -> bool:
    # Python's library tries to import modules of other systems, e.g. `_wmi` and `msvcrt`.
    # Its module `copy` tries to import modules of Jython.
    return name.startswith("_") or name in sys.stdlib_module_names or name in _JYTHONS
