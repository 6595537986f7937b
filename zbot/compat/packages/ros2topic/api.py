# Written by python -m zbot.compat.generator; do not edit.
"""Topics."""

from zbot.compat.graph_listing import get_msg_class, get_topic_names, get_topic_names_and_types

__all__ = [
    "get_msg_class",
    "get_topic_names",
    "get_topic_names_and_types",
]
