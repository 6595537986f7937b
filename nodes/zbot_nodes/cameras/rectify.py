"""Publish images without the distortion of the lens, as ROS 2's image_proc.

Run:        zbot run image_proc rectify_node
Subscribes: image (sensor_msgs/Image), camera_info (sensor_msgs/CameraInfo)
Publishes:  image_rect (sensor_msgs/Image), only while a node subscribes to it
Parameters: queue_size (5), interpolation (1: linear; 0: nearest, 2: cubic)
Needs:      pip install "zbot[camera]"
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot.libraries.camera_model import PinholeCameraModel
from zbot.libraries.image_array import CvBridge, CvBridgeError
from zbot_nodes.cameras.frame_source import opencv
from zbot_nodes.startup.program import ParameterError, run_node

from sensor_msgs.msg import CameraInfo, Image

_LATE_S = 30.0


class Rectify(zbot.Node):
    """Rectifies each image with the newest calibration.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("RectifyNode", **options)
        depth = max(1, int(self.declare_parameter("queue_size", 5).value))
        self.interpolation = int(self.declare_parameter("interpolation", 1).value)
        if self.interpolation not in range(5):
            raise ParameterError("the parameter interpolation must be 0 to 4")
        self.cv2, self.bridge = opencv(), CvBridge()
        self.info: CameraInfo | None = None
        self.maps: Any = None
        self.publisher = self.create_publisher(Image, "image_rect", depth)
        self.create_subscription(CameraInfo, self.info_topic(), self.calibrate, depth)
        self.create_subscription(Image, "image", self.rectify, depth)

    def info_topic(self) -> str:
        """Return the topic of the calibration: beside that of the images, if it is not remapped."""
        given = self.resolve_topic_name("camera_info")
        if given != self.resolve_topic_name("camera_info", only_expand=True):
            return given
        return f"{self.resolve_topic_name('image').rpartition('/')[0]}/camera_info"

    def calibrate(self, info: CameraInfo) -> None:
        """Keep a calibration. The maps of pixels are made only if it has changed."""
        info.header = type(info.header)()
        if info != self.info:
            self.info, self.maps = info, None

    def rectify(self, image: Image) -> None:
        """Publish the rectified image."""
        if self.info is None or not self.publisher.get_subscription_count():
            return
        if not self.info.k[0]:
            text = "the camera is not calibrated: no image_rect without a calibration"
            self.get_logger().error(text, throttle_duration_sec=_LATE_S)
            return
        if not any(self.info.d):
            self.publisher.publish(image)  # the lens has no distortion
            return
        try:
            raw = self.bridge.imgmsg_to_cv2(image)
            self.publisher.publish(self.rectified(raw, image, self.info))
        except CvBridgeError as error:
            self.get_logger().error(str(error), throttle_duration_sec=_LATE_S)

    def rectified(self, raw: Any, image: Image, info: CameraInfo) -> Image:
        """Return the rectified image as a message."""
        if self.maps is None:
            self.maps = self.pixel_maps(info)
        array = self.cv2.remap(raw, *self.maps, self.interpolation)
        return self.bridge.cv2_to_imgmsg(array, image.encoding, image.header)

    def pixel_maps(self, info: CameraInfo) -> Any:
        """Return for each pixel of a rectified image where it is in the raw image."""
        model = PinholeCameraModel()
        model.from_camera_info(info)
        return self.cv2.initUndistortRectifyMap(
            model.intrinsic_matrix(),
            model.distortion_coeffs(),
            model.rotation_matrix(),
            model.projection_matrix()[:, :3],
            model.full_resolution(),
            self.cv2.CV_32FC1,
        )


def main() -> None:
    """Run until Ctrl-C."""
    run_node(Rectify)


if __name__ == "__main__":
    main()
