# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch_pytest`: launches as fixtures of pytest."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.testing.launch_fixture import fixture

__all__ = [
    "fixture",
]

if TYPE_CHECKING:
    from . import actions as actions
    from . import tools as tools
else:
    __getattr__ = at_first_use(
        __name__,
        "actions",
        "tools",
    )
