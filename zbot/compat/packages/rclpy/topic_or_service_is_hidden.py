# Written by python -m zbot.compat.generator; do not edit.
"""Hidden names."""

from zbot.names import is_hidden as topic_or_service_is_hidden
from zbot.compat.constants import HIDDEN_TOPIC_PREFIX

__all__ = [
    "HIDDEN_TOPIC_PREFIX",
    "topic_or_service_is_hidden",
]
