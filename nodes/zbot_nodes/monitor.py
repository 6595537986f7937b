"""Log whether the temperature is high, low or normal.

Run:        zbot run monitor
Subscribes: temperature (std_msgs/Float32), degrees Celsius
"""

import zbot

from std_msgs.msg import Float32

HIGH_C = 28.0
LOW_C = 22.0


class TemperatureMonitor(zbot.Node):
    """Logs every reading, and warns about high readings."""

    def __init__(self) -> None:
        super().__init__("temperature_monitor")
        self.subscription = self.create_subscription(
            Float32, "temperature", self.judge_temperature, 10
        )
        self.get_logger().info("Temperature monitor started")

    def judge_temperature(self, msg: Float32) -> None:
        """Log one reading."""
        temperature = msg.data
        if temperature > HIGH_C:
            self.get_logger().warn(f"High temperature: {temperature:.2f}°C")
        elif temperature < LOW_C:
            self.get_logger().info(f"Low temperature: {temperature:.2f}°C")
        else:
            self.get_logger().info(f"Normal temperature: {temperature:.2f}°C")


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(TemperatureMonitor())


if __name__ == "__main__":
    main()
