# Written by python -m zbot.compat.generator; do not edit.
"""Descriptions of programs to execute."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.actions.executable import Executable

__all__ = [
    "Executable",
]

if TYPE_CHECKING:
    from . import executable as executable
else:
    __getattr__ = at_first_use(
        __name__,
        "executable",
    )
