"""Say hello to the world, and count.

Run:       zbot run talker
Publishes: chatter (std_msgs/String), once a second
"""

import zbot

from std_msgs.msg import String


class Talker(zbot.Node):
    """Publishes a numbered greeting every second."""

    def __init__(self) -> None:
        super().__init__("talker")
        self.count = 0
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.timer = self.create_timer(1.0, self.greet)

    def greet(self) -> None:
        """Publish one greeting."""
        msg = String()
        msg.data = f"Hello World: {self.count}"
        self.count += 1
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self.publisher.publish(msg)


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(Talker())


if __name__ == "__main__":
    main()
