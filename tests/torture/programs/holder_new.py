"""Node that starts, and ends when it has heard a number of nodes, at the latest after 10 s.

Run:        holder_new.py COUNT
Subscribes: numbers (std_msgs/Int64), see holder_talker.py
"""

from __future__ import annotations

import json
import sys
import time

import zbot

from std_msgs.msg import Int64

_TIMEOUT_S = 10.0


def main() -> None:
    wanted, heard = int(sys.argv[1]), set[int]()
    with zbot.init():
        node = zbot.Node("new")
        node.create_subscription(
            Int64, "numbers", lambda message: heard.add(message.data // 10**9), 10
        )
        deadline = time.monotonic() + _TIMEOUT_S
        while len(heard) < wanted and time.monotonic() < deadline:
            zbot.spin_once(node, timeout_sec=0.1)
    print(json.dumps({"kind": "heard", "count": len(heard)}), flush=True)


if __name__ == "__main__":
    main()
