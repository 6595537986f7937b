"""Program with a robot's node, and the check of how it ends."""

from __future__ import annotations

import os
import time
from typing import TYPE_CHECKING

from tests.conftest import allowed

if TYPE_CHECKING:
    from tests.conftest import Program

LIMIT_S = 1.0
#: Set ZBOT_TEST_SEED to repeat the moments of a failed run.
SEED = os.environ.get("ZBOT_TEST_SEED", str(time.time_ns()))

HEAD = """
import sys, threading, time
import zbot
from std_msgs.msg import String

class Robot(zbot.Node):
    def __init__(self):
        super().__init__("robot")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.subscription = self.create_subscription(String, "chatter", self.listen, 1000)
        self.timer = self.create_timer(0.001, self.tick)

    def tick(self):
        self.publisher.publish(String(data="hello"))

    def listen(self, message):
        self.get_logger().debug(message.data)

zbot.init()
print("up", flush=True)
"""


def stop_without_errors(program: Program, number: int, limit_s: float = LIMIT_S) -> int:
    """Send a signal; check that the program ends in time without errors; return its exit code."""
    begin = time.monotonic()
    code = program.stop(number)
    took_s = time.monotonic() - begin
    for word in ("Traceback", "Error", "Exception", "panicked"):
        assert word not in program.output
    assert took_s < allowed(limit_s)
    return code
