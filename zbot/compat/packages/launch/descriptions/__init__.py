# Written by python -m zbot.compat.generator; do not edit.
"""Descriptions of programs to execute."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.executable import Executable

__all__ = [
    "Executable",
]

if TYPE_CHECKING:
    from . import executable as executable
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "executable",
        ),
    )[0]
