"""Save the map of a topic in files, and exit.

Run: zbot run nav2_map_server map_saver_cli -f lab [-t map] [--fmt pgm] [--mode trinary]
     [--occ 0.65] [--free 0.25]
"""

from __future__ import annotations

import argparse
import sys
import time

import zbot
from zbot.libraries.navigation.map_file import FORMATS, MODES, write_map
from zbot.parameters.ros_args import remove_ros_args
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.remote.wait_for_message import wait_for_message

from nav_msgs.msg import OccupancyGrid

_DEFAULT_WAIT_S = 2.0


def read_arguments(words: list[str]) -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(prog="map_saver_cli", allow_abbrev=False)
    parser.add_argument("-t", dest="topic", default="map", help="topic of the map")
    parser.add_argument("-f", dest="path", default="", help="path of the files without a suffix")
    parser.add_argument("--fmt", default="", choices=["", *FORMATS], help="format of the image")
    parser.add_argument("--mode", default="", choices=["", *MODES], help="meaning of the greys")
    parser.add_argument("--occ", type=float, default=0.0, help="threshold of occupied cells")
    parser.add_argument("--free", type=float, default=0.0, help="threshold of free cells")
    return parser.parse_args(words)


def main() -> None:
    """Save one map."""
    options = read_arguments(remove_ros_args()[1:])
    with zbot.init():
        node = zbot.Node("map_saver")
        wait_s = float(node.declare_parameter("save_map_timeout", _DEFAULT_WAIT_S).value)
        kept = bool(node.declare_parameter("map_subscribe_transient_local", True).value)
        durability = DurabilityPolicy.TRANSIENT_LOCAL if kept else DurabilityPolicy.VOLATILE
        came, grid = wait_for_message(
            OccupancyGrid,
            node,
            options.topic,
            qos_profile=QoSProfile(depth=1, durability=durability),
            time_to_wait=wait_s,
        )
        if not came or grid is None:
            sys.exit(f"error: no map came on the topic {options.topic} in {wait_s:g} s")
        path = options.path or f"map_{int(time.time())}"
        try:
            saved = write_map(grid, path, options.fmt, options.mode, options.free, options.occ)
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")
        node.get_logger().info(f"Map saved in {saved}")


if __name__ == "__main__":
    main()
