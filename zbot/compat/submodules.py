"""Submodules that are imported when they are first used: `import launch; launch.actions.Node`."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable


def submodules(package: str, *names: str) -> Callable[[str], Any]:
    """Return a `__getattr__` for a package, under which these are imported when needed."""

    def imported(name: str) -> Any:
        if name not in names:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        return importlib.import_module(f"{package}.{name}")

    return imported
