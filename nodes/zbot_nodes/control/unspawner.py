"""Deactivate and remove controllers, and exit.

Run: zbot run controller_manager unspawner NAME... [-c controller_manager] [--switch-timeout 5.0]
"""

from __future__ import annotations

import sys

import zbot
from zbot_nodes.control.spawner import Spawner, read_arguments


def main() -> None:
    """Deactivate and remove the controllers."""
    options = read_arguments(sys.argv[1:])
    with zbot.init():
        node = Spawner(options)
        try:
            node.unload(options.controller_names)
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
