from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable


pytestmark = pytest.mark.own_dialect("it runs the examples of zbot's own form")

DOCUMENT = Path(__file__).parents[2] / "docs" / "wire.md"


def program() -> str:
    blocks: list[str] = re.findall(
        r"^```python\n(.*?)^```", DOCUMENT.read_text("utf-8"), re.MULTILINE | re.DOTALL
    )
    assert len(blocks) >= 6
    return "\n".join(blocks)


def test_the_programs_of_the_wire_document_communicate_with_a_node(
    start: Callable[..., Any], capsys: pytest.CaptureFixture[str]
) -> None:
    sensor = start(sys.executable, "-u", "-m", "zbot_nodes.sensor")
    monitor = start(sys.executable, "-u", "-m", "zbot_nodes.monitor")
    sensor.wait_for("Temperature sensor started")
    monitor.wait_for("Temperature monitor started")
    exec(compile(program(), str(DOCUMENT), "exec"), {"__name__": "wire"})
    printed = capsys.readouterr().out
    assert re.search(
        r"^\{'data': 2\d\.\d+\}\napplication/msgpack;std_msgs/msg/Float32$", printed, re.MULTILINE
    )

    assert re.search(r"^message \d+, \d+\.\d ms ago, from [0-9a-f]{32}$", printed, re.MULTILINE)
    assert "{'angle_min': -1.57, 'ranges': [1.0, 1.5, 2.0]}" in printed
    assert "node /temperature_sensor\n" in printed
    assert "node /temperature_monitor\n" in printed
    assert "MP /temperature std_msgs/msg/Float32\n" in printed
    assert "the reading came from temperature_sensor\n" in printed
    assert f"is process {sensor.process.pid} on" in printed
    monitor.wait_for("High temperature: 29.50°C")
