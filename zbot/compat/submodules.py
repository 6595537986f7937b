"""Lazy import of submodules at their first use: `import launch; launch.actions.Node`."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable


def submodules(package: str, *names: str) -> Callable[[str], Any]:
    """Return a `__getattr__` for a package, which imports these submodules at their first use."""

    def imported(name: str) -> Any:
        if name not in names:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        return importlib.import_module(f"{package}.{name}")

    return imported
