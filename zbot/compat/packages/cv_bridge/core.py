"""The same names under their own module."""

from zbot.libraries.image_array import CvBridge, CvBridgeError, getCvType
