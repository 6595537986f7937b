"""Publish images in another form: raw images as JPEG, or JPEG as raw images.

Run:        zbot run image_transport republish --ros-args -p in_transport:=compressed \
                -p out_transport:=raw -r in/compressed:=/camera/image/compressed -r out:=/image
Subscribes: in (sensor_msgs/Image) or in/compressed (sensor_msgs/CompressedImage)
Publishes:  out (sensor_msgs/Image), out/compressed (sensor_msgs/CompressedImage)
Parameters: in_transport ("raw"), out_transport ("": all), out.format ("jpeg"),
            out.jpeg_quality (95)
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.images.image_codec import FORMATS, ImageCodecError, compress, decompress
from zbot_nodes.startup.program import ParameterError, run_node

from sensor_msgs.msg import CompressedImage, Image

RAW, COMPRESSED = "raw", "compressed"
_TRANSPORTS = (RAW, COMPRESSED)
_DEPTH = 10


class Republish(zbot.Node):
    """Publishes each image in the form in which it came, raw or compressed.

    It converts the image to the other form only if a node subscribes to that form.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("image_republisher", **options)
        source = self.transport("in_transport", RAW)
        target = self.transport("out_transport", "")
        self.format = str(self.declare_parameter("out.format", "jpeg").value)
        if self.format not in FORMATS:
            raise ParameterError(f"out.format must be jpeg or png, not '{self.format}'")
        self.declare_parameter("out.jpeg_quality", 95)
        self.raw = self.compressed = None
        if target in {"", RAW}:
            self.raw = self.create_publisher(Image, "out", _DEPTH)
        if target in {"", COMPRESSED}:
            self.compressed = self.create_publisher(CompressedImage, "out/compressed", _DEPTH)
        if source == RAW:
            self.create_subscription(Image, "in", self.accept_raw, _DEPTH)
        else:
            self.create_subscription(
                CompressedImage, "in/compressed", self.accept_compressed, _DEPTH
            )

    def transport(self, name: str, default: str) -> str:
        """Declare the parameter of a transport, and return it."""
        value = str(self.declare_parameter(name, default).value)
        if value and value not in _TRANSPORTS:
            raise ParameterError(f"the parameter {name} must be raw or compressed, not '{value}'")
        self.get_logger().info(f"The '{name}' parameter is set to: {value}")
        return value

    def accept_raw(self, image: Image) -> None:
        """Publish an image, and its compressed form."""
        if self.raw is not None:
            self.raw.publish(image)
        if self.compressed is not None and self.compressed.get_subscription_count():
            quality = int(self.get_parameter("out.jpeg_quality").value)
            self.convert(self.compressed, lambda: compress(image, self.format, quality))

    def accept_compressed(self, message: CompressedImage) -> None:
        """Publish a compressed image, and its raw form."""
        if self.compressed is not None:
            self.compressed.publish(message)
        if self.raw is not None and self.raw.get_subscription_count():
            self.convert(self.raw, lambda: decompress(message))

    def convert(self, publisher: Any, make: Any) -> None:
        """Publish a converted image, or log why the image cannot be converted."""
        try:
            publisher.publish(make())
        except ImageCodecError as error:
            self.get_logger().error(str(error), throttle_duration_sec=5.0)


def main() -> None:
    """Run until Ctrl-C. The command line may give transports: `republish compressed raw`."""
    names = ("in_transport", "out_transport")
    words = remove_ros_args()[1:]
    given: list[zbot.Parameter[Any]] = [
        zbot.Parameter(name, value=word) for name, word in zip(names, words, strict=False)
    ]
    run_node(lambda: Republish(parameter_overrides=given))


if __name__ == "__main__":
    main()
