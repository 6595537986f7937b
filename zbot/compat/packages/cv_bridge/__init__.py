"""ROS 2's `cv_bridge`: images as arrays."""

from zbot.image_array import CvBridge as CvBridge
from zbot.image_array import CvBridgeError as CvBridgeError
