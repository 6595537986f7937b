# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `BufferInterface` and `ConvertRegistration` and `TransformRegistration` and `convert` and `NotImplementedException` and `TypeException`."""

from zbot.tf2.buffer_interface import (
    BufferInterface,
    ConvertRegistration,
    TransformRegistration,
    convert,
)
from zbot.tf2.errors import NotImplementedException, TypeException

__all__ = [
    "BufferInterface",
    "ConvertRegistration",
    "NotImplementedException",
    "TransformRegistration",
    "TypeException",
    "convert",
]
