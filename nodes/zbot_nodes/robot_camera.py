"""Take images of the room, as a simulated camera.

Run:       zbot run robot_camera     (together with zbot run robot_base)
Publishes: camera/image_raw (sensor_msgs/Image), colour, 320 x 240, 15 times a second;
           camera/camera_info (sensor_msgs/CameraInfo) with each image
Try:       zbot topic hz /camera/image_raw
"""

import math

import zbot
from zbot.qos import qos_profile_sensor_data
from zbot_nodes.robot.pose import TRUTH, Pose, pose_of
from zbot_nodes.robot.world import distance

from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo, Image

PERIOD_S = 1 / 15
WIDTH, HEIGHT = 320, 240
FOCAL_LENGTH_PX = 277.0  # 60 degrees from the left edge to the right edge of the image
EYE_M = 0.3  # height above the floor: half of the height of a wall
SKY, FLOOR = 255, 0  # brightness; walls have values in between


def colour_table(sky: int, wall: float, floor: int) -> bytes:
    """Return the value of one colour channel for each brightness."""
    return bytes([floor, *(int(wall * shade) for shade in range(1, 255)), sky])


#: Red, green and blue: a light blue sky, brick-red walls, a grey floor.
COLOURS = (colour_table(170, 1.0, 90), colour_table(210, 0.6, 90), colour_table(250, 0.4, 90))


class Camera(zbot.Node):
    """Draws each column of the image as sky, wall and floor."""

    def __init__(self) -> None:
        super().__init__("camera_driver")
        self.pose = Pose()
        self.image_publisher = self.create_publisher(
            Image, "camera/image_raw", qos_profile_sensor_data
        )
        self.info_publisher = self.create_publisher(
            CameraInfo, "camera/camera_info", qos_profile_sensor_data
        )
        self.subscription = self.create_subscription(Odometry, TRUTH, self.locate, 10)
        self.timer = self.create_timer(PERIOD_S, self.shoot)
        self.get_logger().info("Camera ready: images on /camera/image_raw")

    def locate(self, msg: Odometry) -> None:
        """Store the pose of the robot."""
        self.pose = pose_of(msg)

    def shoot(self) -> None:
        """Publish one image and the camera's parameters."""
        image = Image(width=WIDTH, height=HEIGHT, encoding="rgb8", step=3 * WIDTH)
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = "camera_optical_frame"
        image.data = self.draw()
        self.image_publisher.publish(image)
        info = CameraInfo(header=image.header, width=WIDTH, height=HEIGHT)
        f, cx, cy = FOCAL_LENGTH_PX, WIDTH / 2, HEIGHT / 2
        info.k = [f, 0.0, cx, 0.0, f, cy, 0.0, 0.0, 1.0]
        self.info_publisher.publish(info)

    def draw(self) -> bytes:
        """Return the image row by row, three bytes per pixel."""
        shades = b"".join(self.column(number) for number in range(WIDTH))
        pixels = bytearray(3 * WIDTH * HEIGHT)
        for row in range(HEIGHT):
            line = shades[row::HEIGHT]  # one pixel of each column
            start, end = 3 * WIDTH * row, 3 * WIDTH * (row + 1)
            for colour, table in enumerate(COLOURS):
                pixels[start + colour : end : 3] = line.translate(table)
        return bytes(pixels)

    def column(self, number: int) -> bytes:
        """Return one column from top to bottom, one byte per pixel."""
        x, y, yaw = self.pose
        angle = math.atan((WIDTH / 2 - number) / FOCAL_LENGTH_PX)
        depth = distance(x, y, yaw + angle) * math.cos(angle)
        half = min(HEIGHT // 2, int(FOCAL_LENGTH_PX * EYE_M / max(depth, 0.01)))
        wall = max(40, 220 - int(40 * depth))  # far walls are darker
        outside = HEIGHT // 2 - half
        return bytes([SKY]) * outside + bytes([wall]) * (2 * half) + bytes([FLOOR]) * outside


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(Camera())


if __name__ == "__main__":
    main()
