# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `image_geometry`: geometry of calibrated cameras."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.camera_model import PinholeCameraModel, StereoCameraModel

__all__ = [
    "PinholeCameraModel",
    "StereoCameraModel",
]

if TYPE_CHECKING:
    from . import cameramodels as cameramodels
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "cameramodels",
        ),
    )[0]
