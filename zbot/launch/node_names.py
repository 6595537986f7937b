"""Counter of the names of the nodes that a launch has started."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext

_KEY = "unique_ros_node_names"  # launch_ros uses the same key


def _counts(context: LaunchContext) -> Counter[str]:
    counts: Counter[str] | None = context.get_locals_as_dict().get(_KEY)
    if counts is None:
        counts = Counter()
        context.extend_globals({_KEY: counts})
    return counts


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node, and log a warning if its name was counted before."""
    counts = _counts(context)
    counts[node_name] += 1
    if counts[node_name] > 1:
        text = f"there are now at least {counts[node_name]} nodes with the name {node_name}"
        context.writer.warning("launch_ros", f"{text} created within this launch context")


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return the number of started nodes that have a given name."""
    return _counts(context)[node_name]
