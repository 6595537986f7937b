"""Tests of what is said about a file that defines a node, but starts nothing."""

from __future__ import annotations

import pytest

from zbot.process.main_part import mistake_in, only_defines

CLASS = """\
import rclpy
from rclpy.node import Node
class Talker(Node):
    pass
"""
MAIN = f"{CLASS}def main():\n    rclpy.spin(Talker())\n"


@pytest.mark.parametrize(
    ("source", "reason", "advice"),
    [
        (CLASS, "the class Talker is never used", "spin(Talker()) at the end of the file"),
        (f"{CLASS}print('x')", "the class Talker is never used", "spin(Talker())"),
        (f"{CLASS}rclpy.init()", "the class Talker is never used", "spin(Talker())"),
        (MAIN, "main() is never called", "write main() at the end of the file"),
        (f"{MAIN}if __name__ == '__main__':\n    pass", "main() is never called", "write main()"),
        (f"{MAIN}main", "its main part starts nothing", "write main(), with brackets"),
        (
            f"{MAIN}if __name__ == 'main':\n    main()",
            "its main part starts nothing",
            "write `if __name__ == '__main__':`, not 'main'",
        ),
        (
            f"{CLASS}    def main():\n        rclpy.spin(Talker())",
            "main() is inside the class Talker",
            "move it to the left",
        ),
    ],
)
def test_a_file_that_starts_nothing_says_what_to_write(
    source: str, reason: str, advice: str
) -> None:
    found = mistake_in(source.encode())
    assert found
    assert found.reason == reason
    assert advice in found.advice


@pytest.mark.parametrize(
    "end",
    [
        "main()",
        "if __name__ == '__main__':\n    main()",
        "import threading\nthreading.Thread(target=main).start()",
        "with rclpy.init():\n    rclpy.spin(Talker())",
        "for kind in [Talker]:\n    kind()",
        "while rclpy.ok():\n    time.sleep(0.1)",
        "import fire\nfire.Fire()",
        "import unittest\nunittest.main()",
        "globals()['main']()",
        "import typer\napp = typer.Typer()\napp()",
        "import click\n@click.command()\ndef command():\n    main()\nif True:\n    command()",
    ],
)
def test_a_file_that_may_start_something_is_accepted(end: str) -> None:
    assert mistake_in(f"{MAIN}{end}\n".encode()) is None


@pytest.mark.parametrize("source", ["", "X = 1\ndef helper(): ...\n", "print('x')\n"])
def test_a_file_without_a_node_and_without_main_is_accepted(source: str) -> None:
    assert mistake_in(source.encode()) is None


def test_constants_and_definitions_are_no_start() -> None:
    assert only_defines(f"{MAIN}RATE = 2.0\n".encode())
    assert not only_defines(f"{MAIN}RATE = float('2')\n".encode())
