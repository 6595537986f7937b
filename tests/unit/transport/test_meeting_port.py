"""Tests of the port on which programs meet, and of ports that the system reserves."""

from __future__ import annotations

import socket

import pytest

from zbot.transport import meeting_port as module
from zbot.transport.meeting_port import is_reserved, meeting_port
from zbot.transport.reserved_ports import range_in

WINDOWS = """
Ausschlussbereiche für das Protokoll "tcp"

Startport    Endport
----------    --------
      5357        5357
      7400        7499
     50000       50059     *
"""


@pytest.mark.parametrize(
    ("reserved", "port"),
    [((), 7457), ((7457,), 17457), ((7457, 17457), 27457), ((7457, 17457, 27457), 7457)],
)
def test_programs_meet_on_the_first_port_that_the_system_does_not_reserve(
    reserved: tuple[int, ...], port: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "is_reserved", lambda port: port in reserved)
    assert meeting_port(7) == port


def test_a_port_that_a_program_uses_is_not_reserved() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        assert not is_reserved(port)
    assert not is_reserved(port)


def test_a_port_that_nobody_may_bind_is_reserved(monkeypatch: pytest.MonkeyPatch) -> None:
    class Refused(socket.socket):
        def bind(self, _: object) -> None:
            raise PermissionError

    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        monkeypatch.setattr(socket, "socket", Refused)
        assert not is_reserved(port)  # Windows also refuses a port that a program does not share
    assert is_reserved(port)


def test_the_range_of_windows_is_read_in_any_language() -> None:
    assert range_in(WINDOWS, 7450) == "ports 7400 to 7499"
    assert range_in(WINDOWS, 5357) == "ports 5357 to 5357"
    assert range_in(WINDOWS, 50001) == "ports 50000 to 50059"
    assert range_in(WINDOWS, 7500) == "port 7500"
    assert range_in("", 7500) == "port 7500"
