# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch_pytest`: launches as fixtures of pytest."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.testing.launch_fixture import fixture

__all__ = [
    "fixture",
]

if TYPE_CHECKING:
    from . import actions as actions
    from . import tools as tools
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "actions",
            "tools",
        ),
    )[0]
