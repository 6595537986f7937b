# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `visit_all_entities_and_collect_futures`."""

from zbot.compat.launch_utilities import visit_all_entities_and_collect_futures

__all__ = [
    "visit_all_entities_and_collect_futures",
]
