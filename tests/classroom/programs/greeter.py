"""The talker of the bundled nodes, ten times as fast: nobody waits a second for it.

Run:       greeter.py
Publishes: chatter (std_msgs/String), ten times a second
Prints `Publishing` with the first message.
"""

from __future__ import annotations

import zbot

from std_msgs.msg import String


class Greeter(zbot.Node):
    def __init__(self) -> None:
        super().__init__("greeter")
        self.count = 0
        self.chatter = self.create_publisher(String, "chatter", 10)
        self.create_timer(0.1, self.greet)

    def greet(self) -> None:
        self.chatter.publish(String(data=f"Hello World: {self.count}"))
        if self.count == 0:
            print("Publishing", flush=True)
        self.count += 1


def main() -> None:
    with zbot.init():
        zbot.spin(Greeter())


if __name__ == "__main__":
    main()
