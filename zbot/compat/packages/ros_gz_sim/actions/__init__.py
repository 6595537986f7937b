# Written by python -m zbot.compat.generator; do not edit.
"""The action."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.gazebo import GzServer

__all__ = [
    "GzServer",
]

if TYPE_CHECKING:
    from . import gzserver as gzserver
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "gzserver",
        ),
    )[0]
