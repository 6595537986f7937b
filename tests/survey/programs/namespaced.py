import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node('worker', namespace='fleet')
pubs = [node.create_publisher(String, name, 10).topic_name for name in ('a', '~/b', '/c')]
print(pubs, node.get_name(), node.get_namespace(), node.get_fully_qualified_name(), flush=True)
node.destroy_node()
rclpy.shutdown()
