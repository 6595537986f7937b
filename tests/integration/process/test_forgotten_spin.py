"""A program that ends without spinning is told so, once, and only if it has callbacks."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

HEAD = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
rclpy.init()
node = Node("quiet")
"""
TIMER = "node.create_timer(0.1, print)\n"
SUBSCRIPTION = "node.create_subscription(String, 't', print, 10)\n"
THREAD = """\
import threading
thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
"""
WARNING = (
    "{}:6: {}: the callback never ran, because the program ended without spinning: "
    "write rclpy.spin(node) before its end\n"
)


def run(folder: Path, rest: str) -> tuple[Path, str]:
    program = folder / "program.py"
    program.write_text(HEAD + rest)
    command = [sys.executable, str(program)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    return program, done.stderr


@pytest.mark.parametrize(
    ("rest", "call"),
    [
        (TIMER, "create_timer"),
        (f"{SUBSCRIPTION}node.destroy_node()\nrclpy.shutdown()\n", "create_subscription"),
    ],
)
def test_a_forgotten_spin_is_named_once(tmp_path: Path, rest: str, call: str) -> None:
    program, errors = run(tmp_path, rest)
    assert errors == WARNING.format(program, call)


@pytest.mark.parametrize(
    "rest",
    [
        "node.create_publisher(String, 't', 10).publish(String(data='once'))\n",
        "node.create_rate(100).sleep()\n",
        f"{TIMER}{THREAD}thread.start()\nthread.join(0.5)\n",
        f"one = {SUBSCRIPTION}one.handle.take_message(String, False)",
    ],
)
def test_other_programs_are_left_alone(tmp_path: Path, rest: str) -> None:
    assert "never ran" not in run(tmp_path, rest)[1]
