"""Tests of the command line of `zbot serial`."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

import pytest

from zbot.bridge.devices.serial.port import PortInfo

if TYPE_CHECKING:
    from tests.cli.conftest import Command


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("/dev/ttyNO",), "there is no port /dev/ttyNO"),
        (("--type", "temperature"), "'temperature' is not a topic and its type"),
        (("--type", "a:Flaot32"), "there is no type std_msgs/msg/Flaot32"),
        (("--to", "/led:Bol"), "there is no type std_msgs/msg/Bol"),
        (("--topic", "a", "--names", "b,c"), "use --topic or --names, not both"),
        (("--sketch", "arduno"), "there is no program for 'arduno'"),
    ],
)
def test_wrong_words_are_one_sentence(
    zbot_command: Command, words: tuple[str, ...], told: str
) -> None:
    result = zbot_command("serial", *words)
    assert (result.code, result.out) == (1, "")
    assert told in result.err


def test_ports_are_listed_with_their_names(
    zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    ports = [
        PortInfo("/dev/ttyACM0", "Arduino Uno", is_usb=True),
        PortInfo("COM1", "x", is_usb=False),
    ]
    monkeypatch.setattr("zbot.bridge.devices.serial.port.all_ports", lambda: ports)
    result = zbot_command("serial", "--list")
    assert result.out.splitlines() == ["/dev/ttyACM0  Arduino Uno", "COM1          x"]
    monkeypatch.setattr("zbot.bridge.devices.serial.port.all_ports", list)
    assert zbot_command("serial", "--list").err.startswith("no serial port is on this machine")
    assert "no board is on USB" in zbot_command("serial").err


@pytest.mark.parametrize("board", ["micropython", "circuitpython"])
def test_programs_for_boards_are_python(zbot_command: Command, board: str) -> None:
    result = zbot_command("serial", "--sketch", board)
    assert 'print("temperature:"' in result.out
    ast.parse(result.out)


def test_the_program_for_an_arduino_prints_lines(zbot_command: Command) -> None:
    out = zbot_command("serial", "--sketch", "arduino").out
    assert "Serial.begin(115200);" in out
    assert 'Serial.print("temperature: ");' in out
    assert out.count("{") == out.count("}")
