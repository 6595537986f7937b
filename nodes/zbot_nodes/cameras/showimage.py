"""Show images in the browser, as ROS 2's image_tools shows them in a window.

Run:        zbot run image_tools showimage
Subscribes: image (sensor_msgs/Image)
Parameters: show_image (true), reliability ("reliable"), history ("keep_last"), depth (10)
Needs:      pip install "zbot[web]" to see the images
"""

from __future__ import annotations

from contextlib import nullcontext
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

import zbot
from zbot_nodes.cameras.image_profile import declared_profile
from zbot_nodes.startup.page import shown
from zbot_nodes.startup.program import run_node

from sensor_msgs.msg import Image

if TYPE_CHECKING:
    from contextlib import AbstractContextManager


class ShowImage(zbot.Node):
    """Logs each image. The page shows it.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("showimage", **options)
        self.is_shown = bool(self.declare_parameter("show_image", True).value)
        self.declare_parameter("window_name", "")
        self.subscription = self.create_subscription(
            Image, "image", self.receive, declared_profile(self)
        )

    def receive(self, message: Image) -> None:
        """Log an image."""
        self.get_logger().info(f"Received image #{message.header.frame_id}")


def page_shown(node: zbot.Node) -> AbstractContextManager[object]:
    """Show the panel Pictures of the page."""
    if not isinstance(node, ShowImage) or not node.is_shown:
        return nullcontext()
    topic = quote(node.subscription.topic_name, safe="/")
    return shown(node, f"/pictures?topics={topic}", "image")


def main() -> None:
    """Run until Ctrl-C."""
    run_node(ShowImage, around=page_shown)


if __name__ == "__main__":
    main()
