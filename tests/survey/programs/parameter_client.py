import rclpy
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient

rclpy.init()
node = rclpy.create_node('asks')
client = AsyncParameterClient(node, 'minimal_param_node')
client.wait_for_services(timeout_sec=10.0)
future = client.set_parameters([Parameter('my_parameter', Parameter.Type.STRING, 'from afar')])
rclpy.spin_until_future_complete(node, future)
print('set', future.result().results[0].successful, flush=True)
future = client.get_parameters(['rate'])
rclpy.spin_until_future_complete(node, future)
print('rate', future.result().values[0].double_value, flush=True)
node.destroy_node()
rclpy.shutdown()
