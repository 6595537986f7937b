"""Console that sets another node's parameters, and hears of the change in two ways."""

import rclpy
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler

from std_msgs.msg import Float64

rclpy.init()
node = rclpy.create_node("console")
changed, measured = rclpy.Future(), rclpy.Future()
handler = ParameterEventHandler(node)
handle = handler.add_parameter_callback(
    parameter_name="target",
    node_name="/probe",
    callback=lambda parameter: changed.set_result(parameter.value.double_value),
)
node.create_subscription(
    Float64, "humidity", lambda m: measured.set_result(m.data) if m.data > 60 else None, 10
)
client = AsyncParameterClient(node, "probe")
assert client.wait_for_services(60)


def set_to(name: str, value: object) -> str:
    future = client.set_parameters([Parameter(name, value=value)])
    rclpy.spin_until_future_complete(node, future, timeout_sec=60)
    (result,) = future.result().results
    return f"{name}={value}: {'set' if result.successful else result.reason}"


print(set_to("target", 95.0))
print(set_to("bed", "melons"))
print(set_to("target", 61.5))
for waited in (changed, measured):
    rclpy.spin_until_future_complete(node, waited, timeout_sec=60)
print("event", changed.result(), "measured", measured.result())
values = client.get_parameters(["target", "bed"])
rclpy.spin_until_future_complete(node, values, timeout_sec=60)
print([value.double_value or value.string_value for value in values.result().values])
rclpy.shutdown()
