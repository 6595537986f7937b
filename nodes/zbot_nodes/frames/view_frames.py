"""Draw the tree of all frames into a file, and exit.

Run: zbot run tf2_tools view_frames [-t 5.0] [-o frames]
     It writes frames_TIME.gv, and frames_TIME.pdf if Graphviz is installed, else frames_TIME.svg.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import time
from pathlib import Path

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot.tf2 import Buffer, TransformListener
from zbot.threads.deadline import Deadline
from zbot_nodes.frames.frame_tree import FrameTree

_STEP_S = 0.1


def read_arguments(words: list[str]) -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(prog="view_frames", description="Draw the tree of all frames")
    parser.add_argument("--wait-time", "-t", type=float, default=5.0, help="seconds to listen")
    parser.add_argument("-o", "--output", help="name of the files, without a suffix")
    parser.add_argument("--tf_topic", default="/tf", help="topic of frames that move")
    parser.add_argument("--tf_static_topic", default="/tf_static", help="topic of fixed frames")
    return parser.parse_args(words)


def listen(node: zbot.Node, options: argparse.Namespace) -> FrameTree:
    """Return the frames that came during the waiting time."""
    buffer = Buffer()
    listener = TransformListener(
        buffer, node, tf_topic=options.tf_topic, tf_static_topic=options.tf_static_topic
    )
    node.get_logger().info(f"Listening to tf data for {options.wait_time} seconds...")
    deadline = Deadline(options.wait_time)
    while not deadline.is_over:
        zbot.spin_once(node, timeout_sec=_STEP_S)
    listener.unregister()
    return FrameTree.of(buffer.all_frames_as_yaml(), node.get_clock().now().nanoseconds / 1e9)


def write(tree: FrameTree, name: str) -> Path:
    """Write the drawing. Return the file to look at.

    Raises:
        OSError: A file cannot be written.
    """
    text = Path(f"{name}.gv")
    text.write_text(tree.to_dot(), encoding="utf-8")
    dot = shutil.which("dot")
    if dot is not None:
        picture = Path(f"{name}.pdf")
        words = [dot, "-Tpdf", str(text), "-o", str(picture)]
        if subprocess.run(words, check=False).returncode == 0:  # noqa: S603 - Graphviz
            return picture
    picture = Path(f"{name}.svg")
    picture.write_text(tree.to_svg(), encoding="utf-8")
    return picture


def main() -> None:
    """Draw the tree once."""
    options = read_arguments(remove_ros_args()[1:])
    with zbot.init():
        node = zbot.Node("view_frames")
        try:
            tree = listen(node, options)
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")
        name = options.output or time.strftime("frames_%Y-%m-%d_%H.%M.%S")
        try:
            picture = write(tree, name)
        except OSError as error:
            sys.exit(f"error: cannot write '{error.filename}': {error.strerror}")
        count = len(tree.frames)
        node.get_logger().info(f"Exporting graph of {count} frames in {picture} file...")
        if len(tree.roots) > 1:
            node.get_logger().warn(f"There are several trees, with the roots {tree.roots}")


if __name__ == "__main__":
    main()
