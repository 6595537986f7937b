"""Tests of programs whose meeting port the system reserves, in a network namespace."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed
from zbot.transport.meeting_port import FIRST_PORTS

if TYPE_CHECKING:
    from pathlib import Path

#: Makes the ports below a number unusable, also for root, and runs Python.
SHELL = """
ip link set lo up && echo "$1" > /proc/sys/net/ipv4/ip_unprivileged_port_start || exit 77
shift
exec setpriv --bounding-set -net_bind_service --inh-caps -net_bind_service "$@"
"""
SENSOR = """
import subprocess, sys
def zbot(*words):
    done = subprocess.run([sys.executable, "-m", "zbot", *words], capture_output=True, text=True)
    print(done.stdout, done.stderr)
sensor = subprocess.Popen(
    [sys.executable, "-m", "zbot", "run", "sensor"], stderr=subprocess.PIPE, text=True
)
for line in sensor.stderr:
    print(line)
    if "started" in line:
        break
"""
LISTENERS = """
zbot("topic", "list")
zbot("topic", "echo", "--once", "--timeout", "20", "/temperature")
zbot("doctor")
"""
END = "sensor.kill()"


@pytest.fixture(autouse=True)
def own_records(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep the records of routers apart from those of a former test, whose router may still run."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))


def test_programs_meet_on_another_port_and_one_line_says_so(free_domain: int) -> None:
    output = output_with_ports_from(10_000, SENSOR + LISTENERS + END)
    usual, other = (first + free_domain for first in FIRST_PORTS[:2])
    text = f"the system reserves port {usual}: programs meet on port {other}; `zbot doctor` says"
    assert output.count(text) == 1
    assert "/temperature\n" in output
    assert "data: " in output
    assert "ports below 10000 (`sysctl net.ipv4.ip_unprivileged_port_start` shows it)" in output


def test_a_program_without_any_port_says_that_the_system_reserves_it(free_domain: int) -> None:
    output = output_with_ports_from(30_000, SENSOR + END)
    text = f"the system reserves port {FIRST_PORTS[0] + free_domain}, so other nodes are not found"
    assert output.count(text) == 1
    assert "stop the program" not in output


def output_with_ports_from(first: int, program: str) -> str:
    """Run a program in a network namespace in which no lower port can be used."""
    words = ["unshare", "-n", "sh", "-c", SHELL, "sh", str(first), sys.executable, "-c", program]
    try:
        done = subprocess.run(
            words, capture_output=True, text=True, timeout=allowed(60), check=False
        )
    except FileNotFoundError:
        pytest.skip("this system has no network namespaces")
    if done.returncode:
        pytest.skip(f"no network namespace can be made here: {done.stderr}")
    return done.stdout
