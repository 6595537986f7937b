# Written by python -m zbot.compat.generator; do not edit.
"""The functions that ROS 2 has in a compiled module."""

from zbot.libraries.image_array import cvtColor2, cvtColorForDisplay, getCvType

__all__ = [
    "cvtColor2",
    "cvtColorForDisplay",
    "getCvType",
]
