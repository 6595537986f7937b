"""Base class of nodes that publish the images of a webcam with its calibration."""

from __future__ import annotations

import re
from typing import Any

import zbot
from zbot.libraries.camera_calibration import CameraInfoError
from zbot.libraries.camera_info_manager import CameraInfoManager
from zbot_nodes.cameras.frame_source import FrameSource
from zbot_nodes.startup.program import ParameterError

from sensor_msgs.msg import CameraInfo, Image

ENCODINGS = ("bgr8", "mono8", "rgb8")
_DEPTH = 10
_REOPEN_S = 1.0
_MOST_PIXELS = 10_000


class CameraDriver(zbot.Node):
    """Publishes `image_raw` and `camera_info`. A camera that was unplugged is opened again.

    Subclasses declare the parameters of a driver of ROS 2, and call `begin`.

    Args:
        name: The node's name.
        options: The options of `zbot.Node`.
    """

    def __init__(self, name: str, **options: Any) -> None:
        super().__init__(name, **options)
        self.source: FrameSource | None = None
        self.encoding, self.frame_id = "rgb8", "camera"
        self.is_capturing = True

    def number(self, name: str, default: float, highest: float) -> float:
        """Declare a parameter that must be above 0 and at most `highest`, and return its value."""
        return self.in_range(name, float(self.declare_parameter(name, default).value), highest)

    def in_range(self, name: str, value: float, highest: float) -> float:
        """Return a value that must be above 0 and at most `highest`."""
        if not 0 < value <= highest:
            raise ParameterError(f"the parameter {name} must be above 0 and at most {highest:.0f}")
        return value

    def size(self, width: float, height: float) -> tuple[int, int]:
        """Return the size of images."""
        return (
            int(self.in_range("width of images", width, _MOST_PIXELS)),
            int(self.in_range("height of images", height, _MOST_PIXELS)),
        )

    def begin(self, device: str, size: tuple[int, int], rate_hz: float, camera: str) -> None:
        """Open the camera, and start to publish.

        Args:
            device: The camera, or what stands for it (see `FrameSource`).
            size: Wanted width and height.
            rate_hz: Images per second.
            camera: Name of the camera in its calibration.
        """
        url = str(self.declare_parameter("camera_info_url", "").value)
        self.opened_with = (device, *size, rate_hz)
        self.source = FrameSource(*self.opened_with)
        self.calibration = CameraInfoManager(self, re.sub(r"\W", "_", camera), url)
        try:
            self.calibration.loadCameraInfo()
        except (CameraInfoError, OSError) as error:
            self.get_logger().error(f"the camera has no calibration: {error}")
        self.image_publisher = self.create_publisher(Image, "image_raw", _DEPTH)
        self.info_publisher = self.create_publisher(CameraInfo, "camera_info", _DEPTH)
        self.create_timer(1 / rate_hz, self.capture)
        self.reopening = self.create_timer(_REOPEN_S, self.reopen, autostart=False)
        self.get_logger().info(f"{device}: {rate_hz:g} images a second")

    def capture(self) -> None:
        """Publish one image."""
        if self.source is None or not self.is_capturing:
            return
        frame = self.source.read()
        if frame is None:
            self.get_logger().warn("the camera gives no images: waiting until it is back")
            self.source.close()
            self.source = None
            self.reopening.reset()
            return
        self.publish(frame)

    def reopen(self) -> None:
        """Try to open a camera that was unplugged."""
        try:
            self.source = FrameSource(*self.opened_with)
        except zbot.ZbotError:
            return
        self.reopening.cancel()
        self.get_logger().info("the camera is back")

    def publish(self, frame: Any) -> None:
        """Publish an image and the calibration with the same time."""
        image = image_of(frame, self.encoding)
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = self.frame_id
        self.image_publisher.publish(image)
        info = self.calibration.camera_info or CameraInfo()
        info.header = image.header
        if not info.width:
            info.width, info.height = image.width, image.height
        self.info_publisher.publish(info)

    def destroy_node(self) -> None:
        """Let other programs use the camera."""
        if self.source is not None:
            self.source.close()
        super().destroy_node()


def image_of(frame: Any, encoding: str) -> Image:
    """Return an array of blue, green and red as a message in one of `ENCODINGS`."""
    from zbot_nodes.cameras.frame_source import opencv  # noqa: PLC0415 - takes a second to import

    cv2 = opencv()
    if encoding == "mono8":
        frame = cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY)
    elif encoding == "rgb8":
        frame = cv2.cvtColor(frame, cv2.COLOR_BGR2RGB)
    height, width = frame.shape[:2]
    step = width * (1 if encoding == "mono8" else 3)
    # As bytes, an image needs no check of each value.
    return Image(height=height, width=width, encoding=encoding, step=step, data=frame.tobytes())
