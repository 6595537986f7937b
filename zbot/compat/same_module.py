"""Modules of zbot that are known by a second name, e.g. `launch.logging`."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from types import ModuleType


def stand_for(name: str, module: ModuleType) -> None:
    """Let Python find a module and its loaded submodules under a second name too.

    Then a program that replaces a function of the module replaces it for zbot.
    """
    for known, found in list(sys.modules.items()):
        if known == module.__name__ or known.startswith(f"{module.__name__}."):
            sys.modules[name + known.removeprefix(module.__name__)] = found
