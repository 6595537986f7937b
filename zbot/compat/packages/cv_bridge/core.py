"""The same names under their own module."""

from zbot.image_array import CvBridge as CvBridge
from zbot.image_array import CvBridgeError as CvBridgeError
