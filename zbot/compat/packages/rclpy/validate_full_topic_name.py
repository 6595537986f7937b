# Written by python -m zbot.compat.generator; do not edit.
"""Checks of full names."""

from zbot.errors import (
    InvalidServiceNameError as InvalidServiceNameException,
    InvalidTopicNameError as InvalidTopicNameException,
)
from zbot.names import validate_full_topic_name

__all__ = [
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "validate_full_topic_name",
]
