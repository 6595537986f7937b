"""The same names under their own module."""

from zbot.libraries.camera_model import PinholeCameraModel, StereoCameraModel
