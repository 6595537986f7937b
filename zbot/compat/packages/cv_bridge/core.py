# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `CvBridge` and `CvBridgeError` and `getCvType`."""

from zbot.libraries.image_array import CvBridge, CvBridgeError, getCvType

__all__ = [
    "CvBridge",
    "CvBridgeError",
    "getCvType",
]
