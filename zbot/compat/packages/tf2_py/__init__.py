# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `tf2_py`: the tree of frames without nodes."""

from zbot.tf2.buffer_core import BufferCore
from zbot.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

__all__ = [
    "BufferCore",
    "ConnectivityException",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "TimeoutException",
    "TransformException",
]
