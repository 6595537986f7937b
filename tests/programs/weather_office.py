"""Office that reads the mast: latched, as bytes, with message info, as numpy, by waiting."""

import threading

import numpy as np
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.wait_for_message import wait_for_message

from sensor_msgs.msg import FluidPressure, LaserScan
from std_msgs.msg import String


class Office(Node):
    def __init__(self) -> None:
        super().__init__("office", namespace="coast")
        self.told: dict[str, str] = {}
        self.complete = threading.Event()
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, "station", self.on_station, latched)
        self.create_subscription(LaserScan, "ceiling", self.on_ceiling, qos_profile_sensor_data)
        self.create_subscription(
            FluidPressure, "pressure", self.on_bytes, qos_profile_sensor_data, raw=True
        )

    def tell(self, key: str, text: str) -> None:
        self.told.setdefault(key, text)
        if len(self.told) == 3:
            self.complete.set()

    def on_station(self, station: String, info: dict[str, int]) -> None:
        late = info["received_timestamp"] >= info["source_timestamp"] > 0
        self.tell("station", f"{station.data} {late}")

    def on_ceiling(self, scan: LaserScan) -> None:
        ranges = np.asarray(scan.ranges)
        low = int(np.argmin(ranges))
        angle = scan.angle_min + low * scan.angle_increment
        mean = ranges[np.isfinite(ranges)].mean()
        self.tell("ceiling", f"lowest {ranges[low]:.0f} at {angle:.1f}, mean {mean:.1f}")

    def on_bytes(self, data: bytes) -> None:
        reading = deserialize_message(data, FluidPressure)
        again = serialize_message(reading) == data
        self.tell("bytes", f"{data[:4].hex()} {reading.variance} {again}")


rclpy.init()
office = Office()
executor = SingleThreadedExecutor()
executor.add_node(office)
spinning = threading.Thread(target=executor.spin)
spinning.start()
print("complete", office.complete.wait(60))
for key in sorted(office.told):
    print(key, office.told[key])
executor.shutdown()
spinning.join()
found, reading = wait_for_message(
    FluidPressure, office, "pressure", qos_profile=qos_profile_sensor_data, time_to_wait=60
)
print("waited", found, reading.header.frame_id)
rclpy.shutdown()
