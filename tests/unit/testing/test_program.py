"""Tests of the programs of a test."""

from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING

import pytest

from zbot.testing import Program

if TYPE_CHECKING:
    from collections.abc import Iterator

SOURCE = """
try:
    print("ready")
    print("steady")
    input()
except KeyboardInterrupt:
    print("stopped")
    raise SystemExit(7)
"""


@pytest.fixture
def program() -> Iterator[Program]:
    program = Program(("python3", "-c", SOURCE), stdin=-1)
    yield program
    program.end()


def test_lines_are_waited_for_in_their_order(program: Program) -> None:
    assert program.wait_for("rea") == "ready"
    program.see("ready")
    program.see("steady")
    with pytest.raises(AssertionError, match=r"did not print within 0.01 s: 'ready'; there was:"):
        program.wait_for("ready", timeout=0.01)


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_a_program_is_stopped_as_by_ctrl_c(program: Program) -> None:
    program.wait_for("steady")
    assert program.stop() == 7
    assert program.new_lines() == ["stopped"]
    assert program.output == "ready\nsteady\nstopped"


def test_a_program_that_ended_is_not_waited_for(program: Program) -> None:
    program.process.kill()
    text = re.compile(r"ended with exit code -?\d+ and never printed 'no such'; there was:")
    with pytest.raises(AssertionError, match=text):
        program.wait_for("no such", timeout=300)


def test_a_program_that_ignores_ctrl_c_is_killed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("zbot.testing.program._END_S", 0.1)
    source = "import signal; signal.signal(2, signal.SIG_IGN); print('up'); signal.pause()"
    program = Program(("python", "-c", source))
    program.wait_for("up")
    program.end()
    assert program.process.returncode not in {None, 0}
