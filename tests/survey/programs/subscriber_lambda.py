import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('minimal_subscriber')
subscription = node.create_subscription(
    String, 'topic', lambda msg: node.get_logger().info('I heard: "%s"' % msg.data), 10)
rclpy.spin(node)
