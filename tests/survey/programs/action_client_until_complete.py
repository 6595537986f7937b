import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient

rclpy.init()
node = rclpy.create_node('asker')
client = ActionClient(node, Fibonacci, 'fibonacci')
client.wait_for_server(timeout_sec=10.0)
future = client.send_goal_async(Fibonacci.Goal(order=3))
rclpy.spin_until_future_complete(node, future)
goal_handle = future.result()
result_future = goal_handle.get_result_async()
rclpy.spin_until_future_complete(node, result_future)
print('sequence', list(result_future.result().result.sequence), flush=True)
client.destroy()
node.destroy_node()
rclpy.shutdown()
