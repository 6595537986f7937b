# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `interactive_markers`: markers that a user can move in RViz."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.libraries.interactive_markers import InteractiveMarkerServer, MenuHandler

__all__ = [
    "InteractiveMarkerServer",
    "MenuHandler",
]

if TYPE_CHECKING:
    from . import interactive_marker_server as interactive_marker_server
    from . import menu_handler as menu_handler
else:
    __getattr__ = at_first_use(
        __name__,
        "interactive_marker_server",
        "menu_handler",
    )
