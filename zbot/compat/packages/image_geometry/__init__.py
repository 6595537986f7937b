"""ROS 2's `image_geometry`: geometry of calibrated cameras."""

from zbot.libraries.camera_model import PinholeCameraModel, StereoCameraModel
