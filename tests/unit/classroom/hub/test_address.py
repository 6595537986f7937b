from __future__ import annotations

import socket
import subprocess
import sys
from typing import Any

import ifaddr
import pytest

from zbot.classroom.errors import ClassValueError
from zbot.classroom.hub import address
from zbot.classroom.hub.address import Address, own_addresses, parse_address


@pytest.mark.parametrize(
    ("text", "host", "port"),
    [
        ("192.168.1.10", "192.168.1.10", 7447),
        ("192.168.1.10:8000", "192.168.1.10", 8000),
        (" teacher.local ", "teacher.local", 7447),
        ("[fe80::1]", "fe80::1", 7447),
        ("[fe80::1]:443", "fe80::1", 443),
        ("fe80::1", "fe80::1", 7447),
    ],
)
def test_addresses_are_read(text: str, host: str, port: int) -> None:
    assert parse_address(text) == Address(host, port)


@pytest.mark.parametrize(
    "text",
    [
        "",
        ":7447",
        "host:",
        "host:0",
        "host:65536",
        "host:x",
        "a b",
        "tcp/1.2.3.4",
        "h;i",
        "[::1",
    ],
)
def test_an_invalid_address_is_refused(text: str) -> None:
    with pytest.raises(ClassValueError):
        parse_address(text)


def test_addresses_are_zenoh_endpoints() -> None:
    assert Address("10.0.0.1").endpoint == "tcp/10.0.0.1:7447"
    assert Address("fe80::1", 1).endpoint == "tcp/[fe80::1]:1"


def test_a_machine_knows_its_own_addresses() -> None:
    found = own_addresses()
    assert len(set(found)) == len(found)
    for own in found:
        assert not own.startswith("127.")
        with socket.socket() as probe:
            probe.bind((own, 0))  # only an own address can be bound


def test_addresses_of_all_interfaces_are_known(monkeypatch: pytest.MonkeyPatch) -> None:
    names: dict[str, list[Any]] = {
        "lo": ["127.0.0.1", ("::1", 0, 0)],
        "eth0": ["169.254.7.7"],
        "wlan0": [("fe80::1", 0, 3), "198.51.100.7", "198.51.100.8"],
    }
    adapters = [
        ifaddr.Adapter(name, name, [ifaddr.IP(ip, 24, name) for ip in addresses])
        for name, addresses in names.items()
    ]
    monkeypatch.setattr(ifaddr, "get_adapters", lambda: adapters)
    monkeypatch.setattr(address, "_PROBES", ())
    assert own_addresses() == ["198.51.100.7", "198.51.100.8", "169.254.7.7"]
    monkeypatch.setattr(address, "_PROBES", ("127.0.0.2",))
    monkeypatch.setattr(address, "_source_towards", lambda _: "198.51.100.8")
    assert own_addresses() == ["198.51.100.8", "198.51.100.7", "169.254.7.7"]


def test_a_system_may_refuse_to_list_its_interfaces(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse() -> None:
        raise PermissionError

    monkeypatch.setattr(ifaddr, "get_adapters", refuse)
    monkeypatch.setattr(address, "_PROBES", ())
    assert own_addresses() == []


def test_the_library_is_imported_when_addresses_are_needed() -> None:
    code = "import sys, zbot.classroom.hub.address as a; assert 'ifaddr' not in sys.modules; "
    code += "a.own_addresses(); assert 'ifaddr' in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True, timeout=100)


def test_a_port_with_thousands_of_digits_is_one_error() -> None:
    with pytest.raises(ClassValueError):
        parse_address("teacher:" + "9" * 5000)
