"""Every program of the second lesson, saved as it is printed, and its launch file."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import Program, Start

HEAD = "import rclpy\nfrom rclpy.node import Node\n"
MAIN = """
def main(args=None):
    rclpy.init(args=args)
    node = {name}()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()

if __name__ == '__main__':
    main()
"""
MINIMAL = (
    HEAD
    + """
class MinimalNode(Node):
    def __init__(self):
        super().__init__('minimal_node')
        self.get_logger().info('Hello from ROS2!')
"""
    + MAIN.format(name="MinimalNode")
)
PUBLISHER = (
    HEAD
    + """
from std_msgs.msg import String

class PublisherNode(Node):
    def __init__(self):
        super().__init__('publisher_node')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.timer = self.create_timer(1.0, self.timer_callback)
        self.counter = 0

    def timer_callback(self):
        msg = String()
        msg.data = f'Hello ROS2: {self.counter}'
        self.publisher.publish(msg)
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self.counter += 1
"""
    + MAIN.format(name="PublisherNode")
)
SERVICE = (
    HEAD
    + """
from example_interfaces.srv import AddTwoInts

class ServiceNode(Node):
    def __init__(self):
        super().__init__('service_node')
        self.srv = self.create_service(
            AddTwoInts,
            'add_two_ints',
            self.add_two_ints_callback
        )

    def add_two_ints_callback(self, request, response):
        response.sum = request.a + request.b
        self.get_logger().info(f'{request.a} + {request.b} = {response.sum}')
        return response
"""
    + MAIN.format(name="ServiceNode")
)
SENSOR = (
    HEAD
    + """from std_msgs.msg import Float32
import random

class TemperatureSensor(Node):
    def __init__(self):
        super().__init__('temperature_sensor')
        self.publisher = self.create_publisher(Float32, 'temperature', 10)
        self.timer = self.create_timer(1.0, self.publish_temperature)
        self.get_logger().info('Temperature sensor started')

    def publish_temperature(self):
        msg = Float32()
        # Simulate temperature reading (20-30°C)
        msg.data = 20.0 + random.random() * 10.0
        self.publisher.publish(msg)
        self.get_logger().info(f'Temperature: {msg.data:.2f}°C')

def main(args=None):
    rclpy.init(args=args)
    sensor = TemperatureSensor()
    rclpy.spin(sensor)
    sensor.destroy_node()
    rclpy.shutdown()
"""
)
MONITOR = (
    HEAD
    + """from std_msgs.msg import Float32

class TemperatureMonitor(Node):
    def __init__(self):
        super().__init__('temperature_monitor')
        self.subscription = self.create_subscription(
            Float32,
            'temperature',
            self.temperature_callback,
            10
        )
        self.get_logger().info('Temperature monitor started')

    def temperature_callback(self, msg):
        temp = msg.data
        if temp > 28.0:
            self.get_logger().warn(f'High temperature: {temp:.2f}°C')
        elif temp < 22.0:
            self.get_logger().info(f'Low temperature: {temp:.2f}°C')
        else:
            self.get_logger().info(f'Normal temperature: {temp:.2f}°C')

def main(args=None):
    rclpy.init(args=args)
    monitor = TemperatureMonitor()
    rclpy.spin(monitor)
    monitor.destroy_node()
    rclpy.shutdown()
"""
)
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(
            package='my_robot_pkg',
            executable='temperature_sensor',
            name='sensor'
        ),
        Node(
            package='my_robot_pkg',
            executable='temperature_monitor',
            name='monitor'
        ),
    ])
"""
TEMPERATURE = re.compile(r"(High|Low|Normal) temperature: 2\d\.\d\d°C|30\.00°C")


@pytest.fixture
def run(start: Start, tmp_path: Path) -> Callable[[str], Program]:
    def saved(source: str) -> Program:
        path = tmp_path / f"lesson_{abs(hash(source))}.py"
        path.write_text(source, encoding="utf-8")
        return start("zbot", "run", str(path))

    return saved


def ended(program: Program) -> None:
    program.stop()
    assert "Traceback" not in program.output


def test_a_minimal_node(run: Callable[[str], Program]) -> None:
    program = run(MINIMAL)
    program.wait_for("[minimal_node]: Hello from ROS2!")
    ended(program)


def test_a_publisher(run: Callable[[str], Program], start: Start) -> None:
    program = run(PUBLISHER)
    program.wait_for('[publisher_node]: Publishing: "Hello ROS2: 0"')
    start("zbot", "topic", "echo", "/chatter").wait_for("data: 'Hello ROS2: ")
    ended(program)


def test_a_service(run: Callable[[str], Program], start: Start) -> None:
    program = run(SERVICE)
    call = start(
        *("zbot", "service", "call", "/add_two_ints"),
        *("example_interfaces/srv/AddTwoInts", "{a: 5, b: 3}"),
    )
    call.wait_for("example_interfaces.srv.AddTwoInts_Response(sum=8)")
    program.wait_for("[service_node]: 5 + 3 = 8")
    ended(program)


def test_the_temperature_is_watched(run: Callable[[str], Program]) -> None:
    monitor = run(MONITOR)
    monitor.wait_for("[temperature_monitor]: Temperature monitor started")
    sensor = run(SENSOR)
    sensor.wait_for("[temperature_sensor]: Temperature sensor started")
    sensor.wait_for("[temperature_sensor]: Temperature: 2")
    assert TEMPERATURE.search(monitor.wait_for("temperature: "))
    ended(sensor)
    ended(monitor)


def test_the_package_is_launched(start: Start, tmp_path: Path) -> None:
    sources = tmp_path / "ros2_ws" / "src"
    sources.mkdir(parents=True)
    words = ("pkg", "create", "--build-type", "ament_python", "my_robot_pkg")
    assert zbot(*words, cwd=sources).code == 0
    package = sources / "my_robot_pkg"
    (package / "launch").mkdir()
    (package / "launch" / "temperature_system.launch.py").write_text(LAUNCH, encoding="utf-8")
    module = package / "my_robot_pkg"
    (module / "temperature_sensor.py").write_text(SENSOR, encoding="utf-8")
    (module / "temperature_monitor.py").write_text(MONITOR, encoding="utf-8")
    setup = (package / "setup.py").read_text(encoding="utf-8")
    points = ", ".join(
        f"'temperature_{role} = my_robot_pkg.temperature_{role}:main'"
        for role in ("sensor", "monitor")
    )
    setup = re.sub(r"'console_scripts': \[\s*\]", f"'console_scripts': [{points}]", setup)
    (package / "setup.py").write_text(setup, encoding="utf-8")

    launch = start(
        "zbot",
        "launch",
        "my_robot_pkg",
        "temperature_system.launch.py",
        env={"ZBOT_WORKSPACE": str(sources)},
    )
    launch.wait_for("[temperature_sensor-1]")
    assert TEMPERATURE.search(
        launch.wait_for("[monitor]: "[:-2]) + launch.wait_for("temperature: ")
    )
    nodes = start("zbot", "node", "list")
    assert nodes.wait() == 0
    assert nodes.output == "/monitor\n/sensor"
    launch.stop()
    assert "Traceback" not in launch.output
