"""Message type of your own, written as a dataclass. Nothing has to be built."""

from dataclasses import dataclass, field

import zbot


@dataclass
class Battery:
    name: str = ""
    volts: float = 0.0
    cells: list[float] = field(default_factory=list)


class Charger(zbot.Node):
    def __init__(self) -> None:
        super().__init__("charger")
        self.volts = 11.0
        self.publisher = self.create_publisher(Battery, "battery", 10)
        self.create_subscription(Battery, "battery", self.on_battery, 10)
        self.create_timer(0.5, self.charge)

    def charge(self) -> None:
        self.volts = min(self.volts + 0.1, 12.6)
        self.publisher.publish(Battery("main", self.volts, [self.volts / 3] * 3))

    def on_battery(self, battery: Battery) -> None:
        self.get_logger().info(
            f"{battery.name}: {battery.volts:.1f} V in {len(battery.cells)} cells"
        )


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Charger())
