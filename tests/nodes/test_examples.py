"""Tests of the programs in `examples/`, each in a process of its own."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.conftest import Start

EXAMPLES = Path(__file__).parents[2] / "examples"
SAYS = {
    "own_message.py": "main: 11.2 V in 3 cells",
    "call_in_a_callback.py": "2 + 2 = 4",
    "await_services.py": "here is your tea of hot water",
    "live_parameters.py": "blink (2.0 Hz)",
    "keep_all.py": "keep-all saw [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]",
}


def test_every_example_is_run_and_listed() -> None:
    names = {path.name for path in EXAMPLES.glob("*.py")}
    assert names == {*SAYS, "plain_zenoh.py"}
    listed = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    assert all(f"({name})" in listed for name in names)


@pytest.mark.parametrize("name", SAYS)
def test_an_example_prints_its_documented_output(name: str, start: Start) -> None:
    example = start("zbot", "run", str(EXAMPLES / name))
    example.wait_for(SAYS[name])
    example.stop()
    assert "Traceback" not in example.output


def test_the_plain_zenoh_program_reads_the_sensor(start: Start) -> None:
    start("zbot", "run", "sensor").wait_for("Temperature: ")
    reader = start(sys.executable, str(EXAMPLES / "plain_zenoh.py"))
    reader.wait_for("degrees")


def test_a_parameter_of_the_example_changes_its_rate(start: Start) -> None:
    blinker = start("zbot", "run", str(EXAMPLES / "live_parameters.py"))
    blinker.wait_for("blink (2.0 Hz)")
    assert start("zbot", "param", "set", "/blinker", "rate", "9.0").wait() == 0
    blinker.wait_for("blink (9.0 Hz)")
