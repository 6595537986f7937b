# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch_testing_ros`: tests of launch files with nodes."""

from typing import TYPE_CHECKING

from zbot.compat.first_use import at_first_use
from zbot.launch.testing.topics import WaitForTopics

__all__ = [
    "WaitForTopics",
]

if TYPE_CHECKING:
    from . import actions as actions
    from . import tools as tools
    from . import wait_for_topics as wait_for_topics
else:
    __getattr__ = at_first_use(
        __name__,
        "actions",
        "tools",
        "wait_for_topics",
    )
