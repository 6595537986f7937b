import rclpy
from rclpy.qos import QoSDurabilityPolicy, QoSProfile
from std_msgs.msg import String


def heard(msg):
    print('late, but heard:', msg.data, flush=True)


rclpy.init()
node = rclpy.create_node('late')
qos = QoSProfile(depth=1, durability=QoSDurabilityPolicy.TRANSIENT_LOCAL)
node.create_subscription(String, 'map', heard, qos)
rclpy.spin(node)
