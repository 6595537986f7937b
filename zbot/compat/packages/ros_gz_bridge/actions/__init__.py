# Written by python -m zbot.compat.generator; do not edit.
"""The action."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.gazebo import RosGzBridge

__all__ = [
    "RosGzBridge",
]

if TYPE_CHECKING:
    from . import ros_gz_bridge as ros_gz_bridge
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "ros_gz_bridge",
        ),
    )[0]
