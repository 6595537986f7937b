import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('map_server')
qos = QoSProfile(
    depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, reliability=ReliabilityPolicy.RELIABLE)
publisher = node.create_publisher(String, 'map', qos)
publisher.publish(String(data='the map'))
node.get_logger().info('published once')
rclpy.spin(node)
