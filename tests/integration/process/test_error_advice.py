"""The error that ends a program says what to write, also if `python` has started it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start

MISTAKE = """\
import sys
import rclpy
from rclpy.node import Node

class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.get_logger.info("ready")

rclpy.init()
Robot()
"""
ERROR = (
    "AttributeError: 'function' object has no attribute 'info': "
    "write get_logger().info, with parentheses"
)


@pytest.mark.parametrize("start_with", [("python",), ("zbot", "run")])
def test_the_error_that_ends_a_program_says_what_to_write(
    start: Start, tmp_path: Path, start_with: tuple[str, ...]
) -> None:
    (tmp_path / "sheet.py").write_text(MISTAKE)
    program = start(*start_with, "sheet.py")
    assert program.wait() == 1
    assert program.lines[-1] == ERROR
    assert program.output.count("Traceback") == 1


@pytest.mark.parametrize(
    ("source", "advice"),
    [
        ("import rclpy\nclass Robot(rclpy.Node): ...\n", "write rclpy.node.Node"),
        ("from rclpy import node\nclass Robot(node): ...\n", "write the class in the module, e.g."),
        ("from std_msgs.msg import String\nString().text\n", "; it has data"),
    ],
)
def test_an_error_before_init_says_what_to_write(start: Start, source: str, advice: str) -> None:
    program = start(source=source)
    assert program.wait() == 1
    assert advice in program.lines[-1]


def test_the_error_that_ends_a_thread_says_what_to_write(start: Start, tmp_path: Path) -> None:
    in_a_thread = "import threading\nthreading.Thread(target=Robot).start()\n"
    (tmp_path / "sheet.py").write_text(MISTAKE.removesuffix("Robot()\n") + in_a_thread)
    program = start("python", "sheet.py")
    assert program.wait() == 0
    assert ERROR in program.lines


def test_a_hook_of_the_program_stays_alone(start: Start, tmp_path: Path) -> None:
    hook = "import sys\nsys.excepthook = lambda kind, value, trace: print('mine:', value)\n"
    (tmp_path / "sheet.py").write_text(f"{hook}{MISTAKE}")
    program = start("python", "sheet.py")
    assert program.wait() == 1
    assert program.output.strip() == "mine: 'function' object has no attribute 'info'"
