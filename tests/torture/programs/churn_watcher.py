"""Node that watches the whole graph, and that has a subscription."""

from __future__ import annotations

import contextlib
import json

import zbot

from std_msgs.msg import String


def main() -> None:
    with zbot.init():
        node = zbot.Node("watcher")
        node.create_subscription(String, "t", print, 10)
        node.get_topic_names_and_types()
        print(json.dumps({"kind": "ready"}), flush=True)
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(node)


if __name__ == "__main__":
    main()
