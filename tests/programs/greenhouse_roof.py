"""Roof whose names and parameters come from its command line, beside words of its own."""

import argparse
import sys

import rclpy
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.utilities import remove_ros_args

from std_msgs.msg import Empty


class Roof(Node):
    def __init__(self) -> None:
        super().__init__("roof", automatically_declare_parameters_from_overrides=True)
        self.publisher = self.create_publisher(Empty, "opened", 1)


rclpy.init()
own = argparse.ArgumentParser()
own.add_argument("--windows", type=int, default=1)
given = own.parse_args(remove_ros_args(sys.argv)[1:])
roof = Roof()
print(roof.get_fully_qualified_name(), roof.publisher.topic_name, given.windows)
for name in ("angles", "hinges", "open_at", "panes"):
    parameter = roof.get_parameter(name)
    print(
        name,
        parameter.type_.name,
        list(parameter.value) if "ARRAY" in parameter.type_.name else parameter.value,
    )
roof.declare_parameters("motor", [("volts", 24.0), ("names", ["a", "b"])])
print(sorted(roof.get_parameters_by_prefix("motor")), roof.has_parameter("motor.amps"))
(result,) = roof.set_parameters([Parameter("motor.volts", value="many")])
print("set to a text:", result.successful, roof.get_parameter("motor.volts").value)
print(roof.get_parameter_or("motor.amps", Parameter("amps", value=3)).value)
try:
    roof.get_parameter("motor.amps")
except ParameterNotDeclaredException:
    print("not declared")
rclpy.shutdown()
