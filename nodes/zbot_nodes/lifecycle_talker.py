"""Say hello to the world, but only while active: a managed node.

Run:       zbot run lifecycle_talker
Then:      zbot lifecycle set /lc_talker configure
           zbot lifecycle set /lc_talker activate
Publishes: lifecycle_chatter (std_msgs/String), once a second
"""

import zbot
from zbot.lifecycle import (
    LifecycleNode,
    LifecyclePublisher,
    LifecycleState,
    TransitionCallbackReturn,
)

from std_msgs.msg import String


class LifecycleTalker(LifecycleNode):
    """Has a publisher and a timer between the transitions configure and cleanup."""

    def __init__(self) -> None:
        super().__init__("lc_talker")
        self.count = 0
        self.publisher: LifecyclePublisher[String] | None = None
        self.timer: zbot.Timer | None = None

    def greet(self) -> None:
        """Publish one greeting. It is sent only while the node is active."""
        if self.publisher is None:
            return
        msg = String()
        msg.data = f"Lifecycle HelloWorld #{self.count}"
        self.count += 1
        if self.publisher.is_activated:
            self.get_logger().info(f"Lifecycle publisher is active. Publishing: [{msg.data}]")
        else:
            self.get_logger().info(
                "Lifecycle publisher is currently inactive. Messages are not published."
            )
        self.publisher.publish(msg)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Make the publisher and the timer."""
        self.publisher = self.create_lifecycle_publisher(String, "lifecycle_chatter", 10)
        self.timer = self.create_timer(1.0, self.greet)
        self.get_logger().info("on_configure() is called.")
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Let the publisher publish."""
        self.get_logger().info("on_activate() is called.")
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the publisher from publishing."""
        self.get_logger().info("on_deactivate() is called.")
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the publisher and the timer."""
        self.destroy_entities()
        self.get_logger().info("on_cleanup() is called.")
        return super().on_cleanup(state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the publisher and the timer before the end."""
        self.destroy_entities()
        self.get_logger().info("on_shutdown() is called.")
        return super().on_shutdown(state)

    def destroy_entities(self) -> None:
        """Destroy the publisher and the timer, if `on_configure` made them."""
        if self.timer is not None:
            self.destroy_timer(self.timer)
        if self.publisher is not None:
            self.destroy_lifecycle_publisher(self.publisher)
        self.timer = self.publisher = None


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(LifecycleTalker())


if __name__ == "__main__":
    main()
