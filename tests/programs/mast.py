"""Weather mast without a class: readings at a rate from the main thread, and a latched name."""

import threading
from array import array

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data

from sensor_msgs.msg import FluidPressure, LaserScan
from std_msgs.msg import String


def spin(node: rclpy.node.Node) -> None:
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        print("the mast is folded")


rclpy.init()
mast = rclpy.create_node("mast", namespace="coast")
latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
name_publisher = mast.create_publisher(String, "station", latched)
name_publisher.publish(String(data="North Head"))
pressure_publisher = mast.create_publisher(FluidPressure, "pressure", qos_profile_sensor_data)
cloud_publisher = mast.create_publisher(LaserScan, "ceiling", qos_profile_sensor_data)
spinning = threading.Thread(target=spin, args=(mast,))
spinning.start()
rate = mast.create_rate(50)
reading = FluidPressure(variance=4.0)
ceiling = LaserScan(angle_min=-0.2, angle_increment=0.1, range_max=900.0)
ceiling.ranges = array("f", [700.0, 300.0, 250.0, float("inf"), 500.0])
print("the mast stands")
try:
    while rclpy.ok():
        reading.header.stamp = ceiling.header.stamp = mast.get_clock().now().to_msg()
        reading.header.frame_id = "mast"
        reading.fluid_pressure += 1.0
        pressure_publisher.publish(reading)
        cloud_publisher.publish(ceiling)
        rate.sleep()
except (KeyboardInterrupt, rclpy.exceptions.ROSInterruptException):
    rclpy.try_shutdown()
spinning.join()
