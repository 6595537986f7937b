"""Publish 1000 messages a second for two beats of every four of the monotonic clock.

Run:       flood.py [--hz 1000] [--size 100] [--beat 1]      a beat in seconds
Publishes: flood (std_msgs/String), SIZE characters
"""

from __future__ import annotations

import argparse
import time

import zbot

from std_msgs.msg import String


class Flood(zbot.Node):
    def __init__(self, hz: float, size: int, beat_s: float) -> None:
        super().__init__("flood")
        self.beat_s = beat_s
        self.flood = self.create_publisher(String, "flood", 10)
        self.water = String(data="x" * size)
        self.create_timer(1 / hz, self.pour)
        print("flood", flush=True)

    def pour(self) -> None:
        if int(time.monotonic() / self.beat_s) % 4 < 2:
            self.flood.publish(self.water)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--hz", type=float, default=1000)
    parser.add_argument("--size", type=int, default=100)
    parser.add_argument("--beat", type=float, default=1)
    options = parser.parse_args()
    with zbot.init():
        zbot.spin(Flood(options.hz, options.size, options.beat))


if __name__ == "__main__":
    main()
