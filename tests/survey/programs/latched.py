import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('latched')
profile = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
node.create_publisher(String, 'map_name', profile).publish(String(data='warehouse'))
late = rclpy.create_node('late')
late.create_subscription(String, 'map_name', lambda m: print('got', m.data, flush=True), profile)
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(node)
executor.add_node(late)
executor.spin()
