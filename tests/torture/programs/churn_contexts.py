"""Program that opens and closes contexts, each with a node, a publisher and a subscription.

Run: churn_contexts.py COUNT
"""

from __future__ import annotations

import json
import sys
import time

import zbot

from std_msgs.msg import String


def main() -> None:
    begin = time.perf_counter()
    for number in range(int(sys.argv[1])):
        with zbot.Context() as context:
            node = zbot.Node(f"visitor{number}", context=context)
            node.create_subscription(String, "t", print, 10)
            node.create_publisher(String, "t", 10).publish(String(data="here"))
    each_s = (time.perf_counter() - begin) / int(sys.argv[1])
    print(json.dumps({"kind": "end", "each_s": each_s}), flush=True)


if __name__ == "__main__":
    main()
