"""Import of submodules and names of a package when they are used, e.g. `launch.actions`."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable


def at_first_use(package: str, *modules: str, **names: str) -> Callable[[str], Any]:
    """Return a `__getattr__` for a package, which imports submodules and names.

    Args:
        package: The package's name.
        modules: Names of its submodules.
        names: The module of each name that is imported later, because its import takes long.
    """

    def imported(name: str) -> Any:
        if name in names:
            return getattr(importlib.import_module(names[name]), name)
        if name in modules:
            return importlib.import_module(f"{package}.{name}")
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return imported
