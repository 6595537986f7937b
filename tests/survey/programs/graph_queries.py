import time

import rclpy
from std_msgs.msg import String
from std_srvs.srv import SetBool

rclpy.init()
node = rclpy.create_node('looker')
node.create_publisher(String, 'chatter', 10)
node.create_service(SetBool, 'switch', lambda q, r: r)
print(('/chatter', ['std_msgs/msg/String']) in node.get_topic_names_and_types(),
      ('/switch', ['std_srvs/srv/SetBool']) in node.get_service_names_and_types(),
      node.get_node_names_and_namespaces(), node.count_publishers('/chatter'),
      node.get_publishers_info_by_topic('/chatter')[0].node_name, flush=True)
rclpy.shutdown()
