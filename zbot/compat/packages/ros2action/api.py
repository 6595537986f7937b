# Written by python -m zbot.compat.generator; do not edit.
"""Actions."""

from zbot.compat.graph_listing import get_action_names, get_action_names_and_types

__all__ = [
    "get_action_names",
    "get_action_names_and_types",
]
