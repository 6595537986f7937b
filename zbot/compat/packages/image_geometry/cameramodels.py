# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for all names of `image_geometry`."""

from zbot.libraries.camera_model import PinholeCameraModel, StereoCameraModel

__all__ = [
    "PinholeCameraModel",
    "StereoCameraModel",
]
