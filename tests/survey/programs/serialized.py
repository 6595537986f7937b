import rclpy
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('serialized')
pub = node.create_publisher(String, 'chatter', 10)
node.create_subscription(
    String, 'chatter',
    lambda data: print('raw', data[:4], deserialize_message(data, String).data, flush=True), 10, raw=True)
node.create_timer(0.1, lambda: pub.publish(serialize_message(String(data='as bytes'))))
rclpy.spin(node)
