"""Publish the images of a webcam, or of a test picture, as ROS 2's image_tools.

Run:        zbot run image_tools cam2image
            zbot run image_tools cam2image --ros-args -p burger_mode:=true   (needs no camera)
Publishes:  image (sensor_msgs/Image)
Subscribes: flip_image (std_msgs/Bool)
Parameters: device_id (0), video_device ("": a video file or a folder in place of the webcam),
            width (320), height (240), frequency (30.0), frame_id ("camera_frame"),
            burger_mode (false), reliability ("reliable"), history ("keep_last"), depth (10)
Needs:      pip install "zbot[camera]"
"""

from __future__ import annotations

from typing import Any

from zbot_nodes.cameras.camera_driver import CameraDriver, image_of
from zbot_nodes.cameras.frame_source import FrameSource, opencv
from zbot_nodes.cameras.image_profile import declared_profile
from zbot_nodes.startup.program import run_node

from sensor_msgs.msg import Image
from std_msgs.msg import Bool

_MOST_HZ = 1000.0
_STEP = 4  #: pixels that the ball of the test picture moves


class Cam2Image(CameraDriver):
    """Publishes images, mirrored if a message on `flip_image` says so.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("cam2image", **options)
        profile = declared_profile(self)
        self.declare_parameter("show_camera", False)
        device = str(self.declare_parameter("device_id", 0).value)
        device = str(self.declare_parameter("video_device", "").value) or device
        self.frame_id = str(self.declare_parameter("frame_id", "camera_frame").value)
        width = self.declare_parameter("width", 320).value
        height = self.declare_parameter("height", 240).value
        rate_hz = self.number("frequency", 30.0, _MOST_HZ)
        self.image_size = self.size(width, height)
        is_test = bool(self.declare_parameter("burger_mode", False).value)
        self.source = None if is_test else FrameSource(device, *self.image_size, rate_hz)
        self.is_flipped, self.count = False, 0
        self.image_publisher = self.create_publisher(Image, "image", profile)
        self.create_subscription(Bool, "flip_image", self.flip, 10)
        self.create_timer(1 / rate_hz, self.capture)

    def flip(self, message: Bool) -> None:
        """Mirror the images, or mirror them no longer."""
        self.is_flipped = message.data
        self.get_logger().info(f"Set flip mode to: {'on' if message.data else 'off'}")

    def capture(self) -> None:
        """Publish one image."""
        frame = self.test_picture() if self.source is None else self.source.read()
        if frame is None:
            self.get_logger().error("the camera gives no images", throttle_duration_sec=5.0)
            return
        if self.is_flipped:
            frame = opencv().flip(frame, 1)
        self.count += 1
        image = image_of(frame, "bgr8")
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = self.frame_id
        self.get_logger().info(f"Publishing image #{self.count}")
        self.image_publisher.publish(image)

    def test_picture(self) -> Any:
        """Return a picture of a ball that moves from left to right."""
        import numpy as np  # noqa: PLC0415 - an extra

        width, height = self.image_size
        frame = np.full((height, width, 3), (90, 60, 30), np.uint8)
        centre = (self.count * _STEP % width, height // 2)
        opencv().circle(frame, centre, max(1, height // 6), (40, 160, 250), -1)
        return frame


def main() -> None:
    """Run until Ctrl-C."""
    run_node(Cam2Image)


if __name__ == "__main__":
    main()
