from __future__ import annotations

import socket

import pytest

from zbot.classroom.address import Address, own_addresses, parse_address
from zbot.classroom.errors import AddressError


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
    with pytest.raises(AddressError):
        parse_address(text)


def test_addresses_are_zenoh_endpoints() -> None:
    assert Address("10.0.0.1").endpoint == "tcp/10.0.0.1:7447"
    assert Address("fe80::1", 1).endpoint == "tcp/[fe80::1]:1"


def test_a_machine_knows_its_own_addresses() -> None:
    found = own_addresses()
    assert len(set(found)) == len(found)
    for address in found:
        assert not address.startswith("127.")
        with socket.socket() as probe:
            probe.bind((address, 0))  # only an own address can be bound
