import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String


class Strict(Node):
    def __init__(self):
        super().__init__('strict')
        events = SubscriptionEventCallbacks(deadline=self.missed)
        qos = QoSProfile(depth=10, deadline=Duration(seconds=0.2))
        self.publisher = self.create_publisher(String, 'slow', qos)
        self.create_subscription(String, 'slow', lambda m: None, qos, event_callbacks=events)
        self.publisher.publish(String(data='only one'))

    def missed(self, event):
        self.get_logger().info(f'Requested deadline missed: {event.total_count > 0}')


rclpy.init()
rclpy.spin(Strict())
