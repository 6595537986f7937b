"""The same names under their own module."""

from zbot.libraries.image_array import CvBridge as CvBridge
from zbot.libraries.image_array import CvBridgeError as CvBridgeError
