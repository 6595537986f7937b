"""ROS 2's `cv_bridge`: images as arrays."""

from zbot.libraries.image_array import (
    CvBridge,
    CvBridgeError,
    cvtColorForDisplay,
    getCvType,
)
