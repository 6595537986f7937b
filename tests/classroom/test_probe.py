from __future__ import annotations

import socket
import threading
import time

import pytest

from tests.classroom.talk import free_port
from tests.conftest import allowed
from zbot.classroom.errors import ClassValueError, ClosedPortError
from zbot.classroom.hub import probe
from zbot.classroom.hub.address import Address
from zbot.classroom.hub.probe import first_reachable


def test_an_open_port_answers() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        address = Address("127.0.0.1", server.getsockname()[1])
        assert first_reachable([address]) == address


def test_a_port_that_nobody_listens_on_is_refused_soon() -> None:
    begun = time.monotonic()
    with pytest.raises(ClosedPortError, match="zbot class start"):
        first_reachable([Address("127.0.0.1", free_port())])
    assert time.monotonic() - begun < allowed(4)


def test_a_hub_that_opens_again_meanwhile_is_reached() -> None:
    address = Address("127.0.0.1", free_port())
    opened: list[socket.socket] = []

    def listen() -> None:
        opened.append(socket.create_server((address.host, address.port)))

    later = threading.Timer(0.3, listen)
    later.start()
    try:
        assert first_reachable([address], timeout_s=20) == address
    finally:
        later.join()
        for server in opened:
            server.close()


def test_of_several_addresses_the_one_that_answers_is_taken() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        good = Address("127.0.0.1", server.getsockname()[1])
        assert first_reachable([Address("127.0.0.1", free_port()), good]) == good


def test_an_unknown_name_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    def unknown(*_: object, **__: object) -> object:
        raise socket.gaierror("Name or service not known")

    monkeypatch.setattr(socket, "getaddrinfo", unknown)
    with pytest.raises(ClassValueError, match="no machine of that name"):
        first_reachable([Address("teecher.local")])


def test_an_unreachable_name_server_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    over = threading.Event()

    def hang(*_: object, **__: object) -> object:
        over.wait(20)
        raise socket.gaierror("Temporary failure in name resolution")

    monkeypatch.setattr(socket, "getaddrinfo", hang)
    begun = time.monotonic()
    with pytest.raises(ClassValueError, match="no name server answers"):
        first_reachable([Address("teacher.local")], timeout_s=0.2)
    assert time.monotonic() - begun < 15
    over.set()


def test_a_thread_that_runs_late_is_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    def late(*_: object) -> None:
        threading.Event().wait(0.5)

    monkeypatch.setattr(probe, "problem_at", late)
    address = Address("127.0.0.1", 1)
    assert first_reachable([address], timeout_s=0.1) == address
