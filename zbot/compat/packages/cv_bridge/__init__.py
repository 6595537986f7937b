# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `cv_bridge`: images as arrays."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.image_array import CvBridge, CvBridgeError, cvtColorForDisplay, getCvType

__all__ = [
    "CvBridge",
    "CvBridgeError",
    "cvtColorForDisplay",
    "getCvType",
]

if TYPE_CHECKING:
    from . import boost as boost
    from . import core as core
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "boost",
            "core",
        ),
    )[0]
