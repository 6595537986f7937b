"""How many nodes of each name a launch has started."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext

_KEY = "unique_ros_node_names"  # launch_ros's


def _counts(context: LaunchContext) -> Counter[str]:
    counts: Counter[str] | None = context.get_locals_as_dict().get(_KEY)
    if counts is None:
        counts = Counter()
        context.extend_globals({_KEY: counts})
    return counts


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node; a second one of the same name is warned of."""
    counts = _counts(context)
    counts[node_name] += 1
    if counts[node_name] > 1:
        text = f"there are now at least {counts[node_name]} nodes with the name {node_name}"
        context.journal.warning("launch_ros", f"{text} created within this launch context")


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return how many nodes of a name were started."""
    return _counts(context)[node_name]
