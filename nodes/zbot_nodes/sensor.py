"""Simulate a temperature sensor.

Run:       zbot run sensor
Publishes: temperature (std_msgs/Float32), degrees Celsius, once a second
"""

import random

import zbot

from std_msgs.msg import Float32


class TemperatureSensor(zbot.Node):
    """Publishes a random temperature from 20 to 30 degrees every second."""

    def __init__(self) -> None:
        super().__init__("temperature_sensor")
        self.publisher = self.create_publisher(Float32, "temperature", 10)
        self.timer = self.create_timer(1.0, self.publish_temperature)
        self.get_logger().info("Temperature sensor started")

    def publish_temperature(self) -> None:
        """Publish one reading."""
        msg = Float32()
        msg.data = random.uniform(20.0, 30.0)
        self.publisher.publish(msg)
        self.get_logger().info(f"Temperature: {msg.data:.2f}°C")


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(TemperatureSensor())


if __name__ == "__main__":
    main()
