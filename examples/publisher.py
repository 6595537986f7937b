"""Publisher: sends a message once a second on the topic `chatter`."""

import zbot

from std_msgs.msg import String


class Publisher(zbot.Node):
    def __init__(self) -> None:
        super().__init__("publisher")
        self.count = 0
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.create_timer(1.0, self.publish)

    def publish(self) -> None:
        text = f"message {self.count}"
        self.count += 1
        self.publisher.publish(String(data=text))
        self.get_logger().info(f"sent: {text}")


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Publisher())
