"""Managed pump: its publisher and its timer work only while it is active."""

import rclpy
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn

from std_msgs.msg import UInt32


class Pump(LifecycleNode):
    def __init__(self) -> None:
        super().__init__("pump")
        self.litres = 0
        self.flow = None
        self.timer = None

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info(f"valves tested, was {state.label}")
        self.flow = self.create_lifecycle_publisher(UInt32, "flow", 10)
        self.timer = self.create_timer(0.02, self.push)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info("motor on")
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info(f"motor off, some water was moved: {self.litres > 0}")
        return super().on_deactivate(state)

    def on_cleanup(self, _: LifecycleState) -> TransitionCallbackReturn:
        self.destroy_timer(self.timer)
        self.destroy_publisher(self.flow)
        self.get_logger().info("drained")
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, _: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info("scrapped")
        return TransitionCallbackReturn.SUCCESS

    def push(self) -> None:
        if self.flow is not None and self.flow.is_activated:
            self.litres += 1
            self.flow.publish(UInt32(data=self.litres))


rclpy.init()
try:
    rclpy.spin(Pump())
except KeyboardInterrupt:
    rclpy.try_shutdown()
