"""Subscriber: a function of the node is called for each message on the topic `chatter`."""

import zbot

from std_msgs.msg import String


class Subscriber(zbot.Node):
    def __init__(self) -> None:
        super().__init__("subscriber")
        self.create_subscription(String, "chatter", self.receive, 10)

    def receive(self, msg: String) -> None:
        self.get_logger().info(f"received: {msg.data}")


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Subscriber())
