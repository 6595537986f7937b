"""Humidity probe whose target is a parameter: it follows good values and refuses wet ones."""

import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from std_msgs.msg import Float64


class Probe(Node):
    def __init__(self) -> None:
        super().__init__("probe")
        span = FloatingPointRange(from_value=0.0, to_value=100.0)
        about = ParameterDescriptor(description="percent", floating_point_range=[span])
        self.declare_parameter("target", 50.0, about)
        self.declare_parameter("bed", "tomatoes", ParameterDescriptor(read_only=True))
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.follow)
        self.publisher = self.create_publisher(Float64, "humidity", 10)
        self.timer = self.create_timer(0.05, self.measure)

    def judge(self, wanted: list[Parameter]) -> SetParametersResult:
        if any(parameter.name == "target" and parameter.value > 90 for parameter in wanted):
            return SetParametersResult(successful=False, reason="mould grows above 90")
        return SetParametersResult(successful=True)

    def follow(self, changed: list[Parameter]) -> None:
        self.get_logger().info(
            ", ".join(f"{parameter.name} is now {parameter.value}" for parameter in changed)
        )

    def measure(self) -> None:
        self.publisher.publish(Float64(data=self.get_parameter("target").value - 1))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    probe = Probe()
    try:
        rclpy.spin(probe)
    except KeyboardInterrupt:
        pass
    finally:
        probe.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
