"""Open the panel of zbot's web page that replaces a program of rqt.

Run:   zbot run rqt_graph rqt_graph, zbot run rqt_plot rqt_plot /turtle1/pose/x, ...
Needs: pip install "zbot[web]", and a desktop; without a desktop, `zbot web` prints the address
"""

from __future__ import annotations

import os
import sys
from pathlib import PurePath
from typing import TYPE_CHECKING
from urllib.parse import quote

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.startup.page import shown

if TYPE_CHECKING:
    from collections.abc import Sequence

#: For each program: the path of the panel, and the URL parameter for the program's arguments.
PANELS = {
    "rqt": ("/graph", ""),
    "rqt_action": ("/actions", ""),
    "rqt_console": ("/console", ""),
    "rqt_graph": ("/graph", ""),
    "rqt_gui": ("/graph", ""),
    "rqt_image_view": ("/pictures", "topics"),
    "rqt_logger_level": ("/console", ""),
    "rqt_msg": ("/topics", ""),
    "rqt_plot": ("/plot", "curve"),
    "rqt_publisher": ("/topics", ""),
    "rqt_reconfigure": ("/parameters", "node"),
    "rqt_robot_monitor": ("/diagnostics", ""),
    "rqt_robot_steering": ("/drive", ""),
    "rqt_runtime_monitor": ("/diagnostics", ""),
    "rqt_service_caller": ("/services", ""),
    "rqt_tf_tree": ("/frames", ""),
    "rqt_top": ("/processes", ""),
    "rqt_topic": ("/topics", ""),
}
_STANDALONE = ("-s", "--standalone")


def panel_path(program: str, words: Sequence[str]) -> str:
    """Return the path and the query of the panel for a command line.

    Args:
        program: The name of the program, e.g. `rqt_plot`.
        words: The program's arguments. `rqt --standalone rqt_graph` means `rqt_graph`.
    """
    rest = list(words)
    for option in _STANDALONE:
        if option in rest[:-1]:
            named = rest[rest.index(option) + 1].partition(".")[0]
            program = named if named in PANELS else program
            del rest[rest.index(option) : rest.index(option) + 2]
    path, parameter = PANELS.get(program, PANELS["rqt"])
    names = [word for word in rest if not word.startswith("-")]
    if not parameter or not names:
        return path
    value = ",".join(names) if parameter == "curve" else names[0]
    return f"{path}?{parameter}={quote(value, safe='/,')}"


def main() -> None:
    """Run until Ctrl-C, or end immediately if this machine cannot show a page."""
    path = panel_path(PurePath(sys.argv[0]).stem, remove_ros_args()[1:])
    with zbot.init():
        node = zbot.Node(f"rqt_gui_py_node_{os.getpid()}")
        with shown(node, path, "page") as is_shown:
            if is_shown:
                zbot.spin(node)


if __name__ == "__main__":
    main()
