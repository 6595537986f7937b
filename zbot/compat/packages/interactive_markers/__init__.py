# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `interactive_markers`: markers that a user can move in RViz."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.interactive_markers import InteractiveMarkerServer, MenuHandler

__all__ = [
    "InteractiveMarkerServer",
    "MenuHandler",
]

if TYPE_CHECKING:
    from . import interactive_marker_server as interactive_marker_server
    from . import menu_handler as menu_handler
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "interactive_marker_server",
            "menu_handler",
        ),
    )[0]
