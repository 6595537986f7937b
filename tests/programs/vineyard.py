"""Vineyard camera: an image of vines from numpy, by cv_bridge, and back; and points above them."""

import numpy as np
import rclpy
from cv_bridge import CvBridge
from rclpy.node import Node
from sensor_msgs_py import point_cloud2

from sensor_msgs.msg import Image, PointCloud2
from std_msgs.msg import Header


class Vineyard(Node):
    def __init__(self) -> None:
        super().__init__("vineyard")
        self.bridge, self.grapes = CvBridge(), rclpy.Future()
        self.images = self.create_publisher(Image, "rows", 1)
        self.points = self.create_publisher(PointCloud2, "leaves", 1)
        self.create_subscription(Image, "rows", self.on_image, 1)
        self.create_subscription(PointCloud2, "leaves", self.on_points, 1)
        self.create_timer(0.05, self.look)

    def look(self) -> None:
        rows = np.zeros((4, 6, 3), np.uint8)
        rows[:, ::2] = (20, 120, 40)
        self.images.publish(self.bridge.cv2_to_imgmsg(rows, encoding="rgb8"))
        header = Header(frame_id="field")
        self.points.publish(
            point_cloud2.create_cloud_xyz32(header, [(1.0, 2.0, 0.5), (1.0, 3.0, 1.5)])
        )

    def on_image(self, image: Image) -> None:
        rows = self.bridge.imgmsg_to_cv2(image, desired_encoding="bgr8")
        print(image.width, image.height, image.step, rows[3, 4].tolist(), rows.mean(axis=(0, 1)))

    def on_points(self, cloud: PointCloud2) -> None:
        points = point_cloud2.read_points_numpy(cloud, field_names=["x", "y", "z"])
        self.grapes.set_result(f"{points.shape} {points[:, 2].max()} in {cloud.header.frame_id}")


rclpy.init()
node = Vineyard()
rclpy.spin_until_future_complete(node, node.grapes, timeout_sec=60)
print(node.grapes.result())
rclpy.shutdown()
