"""A program that is started with `python` says at its end that it has started nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start

CLASS = """\
import sys
import rclpy
from rclpy.node import Node

class Talker(Node):
    def __init__(self):
        super().__init__("talker")

def main():
    with rclpy.init():
        Talker()

"""


def test_a_program_that_starts_nothing_says_so(start: Start, tmp_path: Path) -> None:
    (tmp_path / "sheet.py").write_text(f"{CLASS}print('hello')\n")
    program = start("python", "sheet.py")
    assert program.wait() == 0
    assert program.lines[0] == "hello"
    assert program.lines[1].endswith(
        "sheet.py: nothing was started: main() is never called: write main() at the end of the file"
    )


@pytest.mark.parametrize("end", ["main()", "print(main)", "sys.exit(0 if main else 1)", "1 / 0"])
def test_other_programs_end_without_a_word(start: Start, tmp_path: Path, end: str) -> None:
    (tmp_path / "sheet.py").write_text(f"{CLASS}{end}\n")
    program = start("python", "sheet.py")
    program.wait()
    assert "nothing was started" not in program.output
