"""Publish the images of a webcam, as ROS 2's v4l2_camera.

Run:        zbot run v4l2_camera v4l2_camera_node
Publishes:  image_raw (sensor_msgs/Image), camera_info (sensor_msgs/CameraInfo)
Services:   set_camera_info (sensor_msgs/SetCameraInfo)
Parameters: video_device ("/dev/video0": also a video file or a folder of pictures),
            image_size ([640, 480]), time_per_frame ([1, 30] s), camera_frame_id ("camera"),
            output_encoding ("rgb8"; bgr8, mono8), camera_info_url ("")
Needs:      pip install "zbot[camera]"
"""

from __future__ import annotations

from typing import Any

from zbot_nodes.cameras.camera_driver import ENCODINGS, CameraDriver
from zbot_nodes.startup.program import ParameterError, run_node

_CAMERA = "v4l2_camera"


class V4l2Camera(CameraDriver):
    """Publishes images.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__(_CAMERA, **options)
        self.declare_parameter("pixel_format", "YUYV")
        device = str(self.declare_parameter("video_device", "/dev/video0").value)
        self.frame_id = str(self.declare_parameter("camera_frame_id", "camera").value)
        self.encoding = str(self.declare_parameter("output_encoding", "rgb8").value)
        if self.encoding not in ENCODINGS:
            known = ", ".join(ENCODINGS)
            raise ParameterError(f"output_encoding must be one of {known}, not '{self.encoding}'")
        width, height = self.pair("image_size", [640, 480])
        seconds, parts = self.pair("time_per_frame", [1, 30])
        self.begin(device, self.size(width, height), parts / seconds, _CAMERA)

    def pair(self, name: str, default: list[int]) -> tuple[int, int]:
        """Declare a parameter of two numbers above 0, and return them."""
        values = list(self.declare_parameter(name, default).value)
        if len(values) != 2 or min(values) <= 0:
            raise ParameterError(f"the parameter {name} must be two numbers above 0: {default}")
        return values[0], values[1]


def main() -> None:
    """Run until Ctrl-C."""
    run_node(V4l2Camera)


if __name__ == "__main__":
    main()
