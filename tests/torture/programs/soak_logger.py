"""Node that floods `/rosout` and `/parameter_events` in bursts.

Run: soak_logger.py
"""

from __future__ import annotations

import contextlib
import os
import sys

import zbot

_BURST = 50
_PERIOD_S = 1.0


class Logger(zbot.Node):
    def __init__(self) -> None:
        super().__init__("soak_logger")
        self.count = 0
        self.declare_parameter("count", 0)
        self.create_timer(_PERIOD_S, self.flood)

    def flood(self) -> None:
        for _ in range(_BURST):
            self.count += 1
            self.get_logger().info(f"line {self.count} ".ljust(500, "x"))
            self.set_parameters([zbot.Parameter("count", value=self.count)])


def main() -> None:
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())  # the file would get large
    with zbot.init():
        node = Logger()
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(node)


if __name__ == "__main__":
    main()
