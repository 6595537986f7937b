"""Drive at a speed that is a parameter.

Run:        zbot run parameter_demo --ros-args -p speed:=0.8
Look:       zbot param describe /parameter_demo speed
Set:        zbot param set /parameter_demo speed 1.5
Parameters: speed (double, 0 to 2 m/s), laps (integer), driver (string), wheel.radius (double,
            metres, read only)
"""

from typing import Any

import zbot

from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    SetParametersResult,
)


class ParameterDemo(zbot.Node):
    """Logs its speed once a second, and every change of a parameter."""

    def __init__(self) -> None:
        super().__init__("parameter_demo")
        speeds = FloatingPointRange(from_value=0.0, to_value=2.0)
        self.declare_parameter(
            "speed",
            0.5,
            ParameterDescriptor(description="Speed in m/s", floating_point_range=[speeds]),
        )
        laps = IntegerRange(from_value=1, to_value=10, step=1)
        self.declare_parameter(
            "laps", 3, ParameterDescriptor(description="Laps to drive", integer_range=[laps])
        )
        self.declare_parameter("driver", "Ada")
        self.declare_parameter(
            "wheel.radius",
            0.05,
            ParameterDescriptor(description="Radius in metres", read_only=True),
        )
        self.add_on_set_parameters_callback(self.check)
        self.add_post_set_parameters_callback(self.log_changes)
        self.timer = self.create_timer(1.0, self.drive)

    def check(self, parameters: list[zbot.Parameter[Any]]) -> SetParametersResult:
        """Reject an empty name of the driver."""
        for parameter in parameters:
            if parameter.name == "driver" and not parameter.value:
                return SetParametersResult(successful=False, reason="a driver needs a name")
        return SetParametersResult(successful=True)

    def log_changes(self, parameters: list[zbot.Parameter[Any]]) -> None:
        """Log the parameters that have changed."""
        for parameter in parameters:
            self.get_logger().info(f"{parameter.name} is now {parameter.value}")

    def drive(self) -> None:
        """Log the driver, the speed and the turns of the wheels."""
        driver = self.get_parameter("driver").value
        speed = self.get_parameter("speed").value
        turns = speed / (2 * 3.141592653589793 * self.get_parameter("wheel.radius").value)
        self.get_logger().info(f"{driver} drives {speed:.2f} m/s: {turns:.1f} turns a second")


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(ParameterDemo())


if __name__ == "__main__":
    main()
