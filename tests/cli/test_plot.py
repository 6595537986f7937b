from __future__ import annotations

import math
import os
import signal
import struct
import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed

from std_msgs.msg import Float64

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program, Spinner


@pytest.fixture
def wave(make_context: Callable[[], zbot.Context], spin: Callable[..., Spinner]) -> zbot.Node:
    node = zbot.Node("robot", context=make_context())
    publisher = node.create_publisher(Float64, "wave", 10)
    node.create_timer(
        0.02, lambda: publisher.publish(Float64(data=math.sin(2 * math.pi * time.time())))
    )
    spin(node)
    return node


def is_drawn(text: str) -> bool:
    return any("⠁" <= mark <= "⣿" for mark in text)


@pytest.mark.usefixtures("wave")
def test_plot_into_a_pipe_is_plain_text(start: Callable[..., Program]) -> None:
    size = {"COLUMNS": "60", "LINES": "16"}
    words = ("--terminal", "--window", "2", "--duration", "3")
    program = start("zbot", "plot", "/wave.data", *words, env=size)
    assert program.wait(30) == 0
    assert "\033" not in program.output
    assert "/wave.data  " in program.output
    last = program.output.rstrip("\n").split("\n\n")[-1].splitlines()
    assert len(last) == 16
    assert max(map(len, last)) <= 60
    drawn = [line for line in last if is_drawn(line)]
    assert len(drawn) >= 8  # the curve rises and falls


def test_plot_needs_a_curve(start: Callable[..., Program]) -> None:
    program = start("zbot", "plot", "--terminal")
    assert program.wait(30) == 2
    assert "say what to plot" in program.output


def test_plot_refuses_an_unknown_field(start: Callable[..., Program]) -> None:
    program = start("zbot", "plot", "--terminal", "/wave.data[")
    assert program.wait(30) == 1
    assert "Invalid field 'data['" in program.output


def test_plot_reports_that_no_message_has_come(start: Callable[..., Program]) -> None:
    program = start("zbot", "plot", "/nothing.x", "--terminal", "--duration", "1.5")
    assert program.wait(30) == 0
    assert "/nothing.x  no message yet" in program.output


class Terminal:
    """Command in a terminal of its own, with its output."""

    def __init__(self, *words: str, columns: int, lines: int) -> None:
        import pty  # noqa: PLC0415 - there is none on Windows

        self._main, end = pty.openpty()
        self.resize(columns, lines)
        command = [sys.executable, "-m", "zbot_cli", *words]
        # pytest sets variables that have precedence over the terminal's size.
        size = {"COLUMNS", "LINES"}
        env = {name: value for name, value in os.environ.items() if name not in size}
        self.process = subprocess.Popen(command, stdin=end, stdout=end, stderr=end, env=env)
        os.close(end)

    def resize(self, columns: int, lines: int) -> None:
        import fcntl  # noqa: PLC0415 - there is none on Windows
        import termios  # noqa: PLC0415 - there is none on Windows

        fcntl.ioctl(self._main, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))

    def read_until(self, condition: Callable[[str], bool]) -> str:
        """Return the output up to when it fulfils a condition or the command has ended."""
        text, deadline = "", time.monotonic() + allowed(30)
        while not condition(text):
            assert time.monotonic() < deadline, text[-2000:]
            try:
                text += os.read(self._main, 65536).decode("utf-8", "replace")
            except OSError:  # Linux raises it at the end of the output
                break
        return text

    def close(self) -> None:
        self.process.kill()
        self.process.wait(5)
        os.close(self._main)


@pytest.mark.usefixtures("wave")
@pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals are POSIX's")
def test_plot_in_a_terminal_follows_its_size_and_ends_with_ctrl_c() -> None:
    terminal = Terminal("plot", "--terminal", "/wave.data", columns=70, lines=20)
    try:
        terminal.read_until(lambda text: text.count("\033[H") > 5 and is_drawn(text))
        terminal.resize(40, 10)
        frames = terminal.read_until(lambda text: text.count("\033[H") > 8).split("\033[H")
        assert frames[-2].count("\n") == 9
        terminal.process.send_signal(signal.SIGINT)
        rest = terminal.read_until(lambda _: False)
        assert terminal.process.wait(allowed(30)) == 130
        assert "\033[?1049l" in rest
        assert is_drawn(rest.partition("\033[?1049l")[2])
        assert "Traceback" not in rest
    finally:
        terminal.close()
