# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch_testing_ros`: tests of launch files with nodes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.testing.topics import WaitForTopics

__all__ = [
    "WaitForTopics",
]

if TYPE_CHECKING:
    from . import actions as actions
    from . import tools as tools
    from . import wait_for_topics as wait_for_topics
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "actions",
            "tools",
            "wait_for_topics",
        ),
    )[0]
