import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image


class Camera(Node):
    def __init__(self):
        super().__init__('camera')
        self.pub = self.create_publisher(Image, '/camera/image_raw', 10)
        self.create_subscription(Image, '/camera/image_raw', self.show, 10)
        self.create_timer(0.05, self.shoot)

    def shoot(self):
        frame = np.zeros((48, 64, 3), dtype=np.uint8)
        frame[:, :, 1] = 7
        msg = Image(height=48, width=64, encoding='bgr8', step=64 * 3)
        msg.data = frame.tobytes()
        self.pub.publish(msg)

    def show(self, msg):
        frame = np.frombuffer(msg.data, dtype=np.uint8).reshape(msg.height, msg.width, 3)
        self.get_logger().info(f'green {frame[:, :, 1].mean():.1f} {msg.encoding}')


rclpy.init()
rclpy.spin(Camera())
