"""Managed node: other programs configure it, activate it, and deactivate it.

Then: zbot lifecycle set /managed configure
      zbot lifecycle set /managed activate
"""

import zbot
from zbot.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn

from std_msgs.msg import String


class Managed(LifecycleNode):
    def __init__(self) -> None:
        super().__init__("managed")
        self.get_logger().info("waiting for a transition")

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.publisher = self.create_lifecycle_publisher(String, "chatter", 10)
        self.timer = self.create_timer(0.5, self.publish)
        self.get_logger().info("configured")
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info("active: messages are sent from now on")
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.get_logger().info("inactive: messages are not sent any more")
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.destroy_timer(self.timer)
        self.destroy_lifecycle_publisher(self.publisher)
        return super().on_cleanup(state)

    def publish(self) -> None:
        self.publisher.publish(String(data="hello"))


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Managed())
