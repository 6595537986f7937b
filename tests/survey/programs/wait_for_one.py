import rclpy
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('waiter')
ok, msg = wait_for_message(String, node, 'topic', time_to_wait=20)
print('one message:', ok, msg.data if ok else None, flush=True)
node.destroy_node()
rclpy.shutdown()
