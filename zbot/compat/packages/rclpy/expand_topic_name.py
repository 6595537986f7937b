# Written by python -m zbot.compat.generator; do not edit.
"""Full names of topics."""

from zbot.names import expand_topic_name

__all__ = [
    "expand_topic_name",
]
