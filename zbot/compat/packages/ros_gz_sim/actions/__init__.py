# Written by python -m zbot.compat.generator; do not edit.
"""The actions."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.gazebo import GzServer, GzSpawnModel

__all__ = [
    "GzServer",
    "GzSpawnModel",
]

if TYPE_CHECKING:
    from . import gz_spawn_model as gz_spawn_model
    from . import gzserver as gzserver
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "gz_spawn_model",
            "gzserver",
        ),
    )[0]
