"""Publish 1000 messages a second in every even second of the monotonic clock, none in odd ones.

Run:       flood.py [--hz 1000]
Publishes: flood (std_msgs/String), 100 characters
"""

from __future__ import annotations

import argparse
import time

import zbot

from std_msgs.msg import String


class Flood(zbot.Node):
    def __init__(self, hz: float) -> None:
        super().__init__("flood")
        self.flood = self.create_publisher(String, "flood", 10)
        self.water = String(data="x" * 100)
        self.create_timer(1 / hz, self.pour)
        print("flood", flush=True)

    def pour(self) -> None:
        if int(time.monotonic()) % 2 == 0:
            self.flood.publish(self.water)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--hz", type=float, default=1000)
    with zbot.init():
        zbot.spin(Flood(parser.parse_args().hz))


if __name__ == "__main__":
    main()
