"""Log the messages of the talker.

Run:        zbot run listener
Subscribes: chatter (std_msgs/String)
"""

import zbot

from std_msgs.msg import String


class Listener(zbot.Node):
    """Logs every greeting that it receives."""

    def __init__(self) -> None:
        super().__init__("listener")
        self.subscription = self.create_subscription(String, "chatter", self.hear, 10)

    def hear(self, msg: String) -> None:
        """Log one greeting."""
        self.get_logger().info(f"I heard: [{msg.data}]")


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(Listener())


if __name__ == "__main__":
    main()
