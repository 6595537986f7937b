# Written by python -m zbot.compat.generator; do not edit.
"""Checks of topics' names."""

from zbot.errors import (
    InvalidServiceNameError as InvalidServiceNameException,
    InvalidTopicNameError as InvalidTopicNameException,
)
from zbot.names import validate_topic_name
from zbot.compat.constants import TOPIC_SEPARATOR_STRING

__all__ = [
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "TOPIC_SEPARATOR_STRING",
    "validate_topic_name",
]
