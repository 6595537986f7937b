"""Tests that text from other programs cannot control the terminal of a command."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import IO, TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.conftest import allowed
from tests.kiosk import start_kiosk

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from tests.conftest import Program, Start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals")

MARK = "mark"
#: Window title, clear screen, the same with one C1 character, delete, and reversed direction.
EVIL = f"\x1b]0;{MARK}\x07\x1b[2J\x9b2J\x7f\u202e{MARK}"
FORBIDDEN = ("\x1b", "\x07", "\x9b", "\x7f", "\u202e")
#: Commands that print the text. The last one ends the program.
COMMANDS = """
action send_goal -f /boil kiosk/action/Boil {}
interface show kiosk/action/Boil
interface show kiosk/msg/Menu
interface show kiosk/srv/Order
param describe /kiosk greeting
param dump /kiosk
param get --hide-type /kiosk greeting
param get /kiosk greeting
param get /kiosk greetings
param list /kiosk
param set /kiosk greeting hello
service call --json /order kiosk/srv/Order {}
service call /order kiosk/srv/Order {}
topic echo --once --timeout 40 --csv /chat
topic echo --once --timeout 40 --field dish /menu
topic echo --once --timeout 40 --filter "m.name == 'kiosk'" /rosout
topic echo --once --timeout 40 --json /chat
topic echo --once --timeout 40 --raw /chat
topic echo --once --timeout 40 /chat
service call /order kiosk/srv/Order '{dish: fail}'
"""
#: Commands that leave out the names, which no node may have.
LISTINGS = """
doctor
graph
graph --dot
graph --json
node list
topic list -v
"""


@pytest.fixture
def kiosk(start: Start, tmp_path: Path) -> Program:
    return start_kiosk(start, tmp_path / "far", EVIL)


def on_terminal(line: str) -> str:
    """Run a command on a pseudo-terminal; return what the terminal got."""
    assert sys.platform != "win32"
    import pty  # noqa: PLC0415 - Windows has none

    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "zbot_cli", *shlex.split(line)]
    process = subprocess.Popen(command, stdin=theirs, stdout=theirs, stderr=theirs)
    os.close(theirs)
    limit = threading.Timer(allowed(60), process.kill)
    limit.start()
    with os.fdopen(ours, "rb", buffering=0) as terminal:
        got = b"".join(iter(lambda: _read(terminal), b""))
    limit.cancel()
    process.wait(5)
    return got.decode()


def _read(terminal: IO[bytes]) -> bytes:
    try:
        return terminal.read(65536)
    except OSError:  # Linux reports the end of the other side as an error
        return b""


def in_terminals(commands: str) -> Iterator[tuple[str, str]]:
    """Run commands, several at the same time; yield each with its output."""
    lines = commands.split("\n")[1:-1]
    with ThreadPoolExecutor(3) as pool:
        yield from zip(lines[:-1], pool.map(on_terminal, lines[:-1]), strict=True)
    yield lines[-1], on_terminal(lines[-1])


@pytest.mark.usefixtures("kiosk")
def test_no_control_sequence_of_others_reaches_the_terminal() -> None:
    for line, text in [*in_terminals(LISTINGS), *in_terminals(COMMANDS)]:
        assert not [char for char in FORBIDDEN if char in text], (line, text)
        assert "Traceback" not in text, (line, text)
        assert (MARK in text) == (line in COMMANDS), (line, text)


@pytest.mark.usefixtures("kiosk")
def test_a_pipe_gets_the_text_unchanged() -> None:
    text = zbot("param", "get", "--hide-type", "/kiosk", "greeting").out
    assert text == f"{EVIL}\n"
    line = zbot("topic", "echo", "--once", "--json", "/chat").out
    assert json.loads(line) == {"data": EVIL}


@pytest.mark.usefixtures("kiosk")
def test_tab_offers_no_parameter_whose_name_a_shell_would_interpret() -> None:
    names = zbot("complete", "--", "param", "get", "/kiosk", "").out.split("\n")
    assert "greeting" in names
    assert not [name for name in names if MARK in name]


PROGRAM = """
import sys, zbot
zbot.init()
log = zbot.get_logger("shop")
log.info(sys.argv[1])
log.info("\\x1b[92mgreen\\x1b[0m")
print("\\x1b[1mown\\x1b[0m")
"""
LAUNCH = """
import sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    command = [sys.executable, {program!r}, {text!r}]
    return LaunchDescription([ExecuteProcess(cmd=command, output="screen")])
"""


@pytest.mark.usefixtures("domain")
def test_the_log_of_a_program_has_colours_and_no_other_sequences(tmp_path: Path) -> None:
    program, launch = tmp_path / "shop.py", tmp_path / "shop.launch.py"
    program.write_text(PROGRAM, encoding="utf-8")
    launch.write_text(LAUNCH.format(program=str(program), text=EVIL), encoding="utf-8")
    for line in (shlex.join(["run", str(program), EVIL]), shlex.join(["launch", str(launch)])):
        text = on_terminal(line)
        assert "\\x1b]0;mark\\x07\\x1b[2J\\x9b2J\\x7f\\u202emark" in text
        assert "\x1b[92mgreen\x1b[0m" in text
        assert "\x1b[1mown\x1b[0m" in text
        assert not [char for char in FORBIDDEN if char in text and char != "\x1b"], text
