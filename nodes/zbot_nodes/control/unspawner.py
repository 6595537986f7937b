"""Deactivate and remove controllers, and exit.

Run: zbot run controller_manager unspawner NAME... [-c controller_manager]
"""

from __future__ import annotations

import sys

import zbot
from zbot_nodes.control.spawner import Spawner, read_arguments

from controller_manager_msgs import srv


def main() -> None:
    """Deactivate and remove the controllers."""
    options = read_arguments(sys.argv[1:])
    with zbot.init():
        node = Spawner(options)
        try:
            node.switch([], options.controller_names)
            for name in options.controller_names:
                node.ask(
                    srv.UnloadController, "unload_controller", f"Failed to unload {name}", name=name
                )
                node.get_logger().info(f"Unloaded {name}")
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
