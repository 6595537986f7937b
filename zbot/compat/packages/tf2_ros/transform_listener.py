# Written by python -m zbot.compat.generator; do not edit.
"""Listeners."""

from zbot.tf2.broadcaster import (
    TF_STATIC_TOPIC as DEFAULT_STATIC_TF_TOPIC,
    TF_TOPIC as DEFAULT_TF_TOPIC,
)
from zbot.tf2.listener import TransformListener

__all__ = [
    "DEFAULT_STATIC_TF_TOPIC",
    "DEFAULT_TF_TOPIC",
    "TransformListener",
]
