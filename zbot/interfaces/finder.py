"""Sources of modules such as `std_msgs.msg`, for zbot's finder of imports.

The modules of an installed ROS 2 have priority, except if zbot is preferred (`import_finder`). The
sources add missing packages. In existing
Python packages, they add missing modules `msg`, `srv` and `action`.

Python asks these sources for every import. `zbot.interfaces.importer` makes the modules. The
sources load `importer` only to find such a module, so `zbot topic list` starts 20 % faster.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.names import KINDS
from zbot.package import import_finder

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
    import_finder.add("interfaces", _find_kind)
    import_finder.add("packages of interfaces", _find_package)
    import_finder.explain(_explain)


def _find_kind(
    fullname: str, path: Sequence[str] | None, target: ModuleType | None
) -> ModuleSpec | None:
    """Return the spec of `std_msgs.msg`, if there are definitions but no real module for them."""
    del target
    package, _, kind = fullname.partition(".")
    if kind not in KINDS or package in _PLAIN_PACKAGES:
        return None
    importer = _importer()
    if importer is None or not importer.has_package(package):
        return None
    real = import_finder.installed_spec(fullname, path)
    if real and not (import_finder.prefers_zbot() and _is_generated(package, path)):
        return None
    spec: ModuleSpec | None = importer.kind_spec(package, kind)
    return spec


def _is_generated(package: str, path: Sequence[str] | None) -> bool:
    """Return whether ROS 2's generator made a package, and not a person."""
    from pathlib import Path  # noqa: PLC0415 - only beside a genuine ROS 2

    library = f"{package}_s__rosidl_typesupport_*"
    return any(True for folder in path or () for _ in Path(folder).glob(library))


def _find_package(
    fullname: str, path: Sequence[str] | None, target: ModuleType | None
) -> ModuleSpec | None:
    """Return the spec of `std_msgs` or `std_msgs.msg._string`."""
    del path, target
    package, _, inside = fullname.partition(".")
    importer = None if _is_pythons(package) else _importer()
    if importer is None or (inside and inside.partition(".")[0] not in KINDS):
        return None
    find = importer.submodule_spec if inside else importer.package_spec
    spec: ModuleSpec | None = find(fullname)
    return spec


def _explain(fullname: str, path: Sequence[str] | None) -> ImportError | None:
    """Return the error for a module that a package of definitions does not have.

    The same for a package that does not exist and has such a name, e.g. `my_msgs`.
    """
    del path
    package, _, inside = fullname.partition(".")
    importer = None if _is_pythons(package) else _importer()
    if importer is None or not (inside or package.endswith(_ENDINGS)):
        return None
    error: ImportError | None = (
        importer.missing_module(package, inside) if inside else importer.missing_package(package)
    )
    return error


def _importer() -> Any:
    """Return the module `importer`, or `None` while Python is still importing it."""
    from zbot.interfaces import importer  # noqa: PLC0415 - see the module's docstring

    return importer if hasattr(importer, "package_spec") else None


def _is_pythons(name: str) -> bool:
    # Python's library tries to import modules of other systems, e.g. `_wmi` and `msvcrt`.
    # Its module `copy` tries to import modules of Jython.
    return name.startswith("_") or name in sys.stdlib_module_names or name in _JYTHONS
