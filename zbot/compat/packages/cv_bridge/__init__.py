"""ROS 2's `cv_bridge`: images as arrays."""

from zbot.libraries.image_array import CvBridge as CvBridge
from zbot.libraries.image_array import CvBridgeError as CvBridgeError
