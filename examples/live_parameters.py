"""Parameter with a range and a description: `zbot param describe /blinker rate`."""

import zbot
from zbot import Parameter

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor


class Blinker(zbot.Node):
    def __init__(self) -> None:
        super().__init__("blinker")
        rate = ParameterDescriptor(
            description="How often it blinks (Hz)",
            floating_point_range=[FloatingPointRange(from_value=0.1, to_value=20.0)],
        )
        self.declare_parameter("rate", 2.0, rate)
        self.declare_parameter("text", "blink")
        self.timer = self.create_timer(1 / self.rate, self.blink)
        self.add_post_set_parameters_callback(self.follow)

    @property
    def rate(self) -> float:
        return self.get_parameter("rate").value

    def blink(self) -> None:
        self.get_logger().info(f"{self.get_parameter('text').value} ({self.rate} Hz)")

    def follow(self, changed: list[Parameter]) -> None:
        if any(parameter.name == "rate" for parameter in changed):
            self.timer.timer_period_ns = int(1e9 / self.rate)
            self.timer.reset()


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Blinker())
