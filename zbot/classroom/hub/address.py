"""Addresses of hubs as users type them, and this machine's own IP addresses."""

from __future__ import annotations

import socket
from dataclasses import dataclass

from zbot.classroom.errors import address_error
from zbot.text.whole_number import whole_number
from zbot.transport.config import HUB_PORT

#: Targets for UDP sockets. `connect` of a UDP socket sends nothing, but the system then chooses
#: the socket's local address. The first target is a documentation address (RFC 5737), which uses
#: the default route.
_PROBES = ("192.0.2.1", "10.255.255.254", "172.31.255.254", "192.168.255.254")
_MAX_PORT = 65535

EVERYWHERE = "0.0.0.0"  #: all interfaces of a machine  # noqa: S104 - the user wants this


@dataclass(frozen=True)
class Address:
    """Host and TCP port of a hub."""

    host: str  #: a name or an IP address
    port: int = HUB_PORT

    def __str__(self) -> str:
        return f"[{self.host}]:{self.port}" if ":" in self.host else f"{self.host}:{self.port}"

    @property
    def endpoint(self) -> str:
        """The address as a Zenoh endpoint, such as `tcp/192.168.1.10:7447`."""
        return f"tcp/{self}"


def parse_address(text: str, default_port: int = HUB_PORT) -> Address:
    """Return the address that a text contains: `HOST`, `HOST:PORT`, `[IPv6]` or `[IPv6]:PORT`.

    Raises:
        ClassValueError: The host is missing or invalid, or the port is not a number from 1 to
            65535.
    """
    host, port = _split(text.strip())
    if not host or any(char.isspace() or not char.isprintable() for char in host):
        raise address_error(text, "write a name or IP address, such as 192.168.1.10")
    if set(host) & set("/#?;"):
        raise address_error(text, "a name or IP address cannot contain / # ? or ;")
    if port is None:
        return Address(host, default_port)
    number = whole_number(port)
    if number is None or not 0 < number <= _MAX_PORT:
        raise address_error(text, f"its port must be a number from 1 to {_MAX_PORT}")
    return Address(host, number)


def _split(text: str) -> tuple[str, str | None]:
    if text.startswith("["):
        host, bracket, rest = text[1:].partition("]")
        return (host, rest[1:] if rest.startswith(":") else None) if bracket else ("", None)
    if text.count(":") > 1:
        return text, None
    host, colon, port = text.partition(":")
    return host, port if colon else None


def own_addresses() -> list[str]:
    """Return this machine's IPv4 addresses without loopback. The default route's address is first.

    The function sends nothing, because all addresses come from the operating system. Addresses that
    an interface has chosen itself (169.254.x.x) are last. Interfaces do so if no server assigns an
    address.
    """
    found = [_source_towards(probe) for probe in _PROBES] + _addresses_of_interfaces()
    known = dict.fromkeys(address for address in found if address)
    usable = [address for address in known if not address.startswith(("127.", "0."))]
    return sorted(usable, key=lambda address: address.startswith("169.254."))


def _source_towards(target: str) -> str:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect((target, 9))
            return str(probe.getsockname()[0])
        except OSError:
            return ""


def _addresses_of_interfaces() -> list[str]:
    import ifaddr  # noqa: PLC0415 - it imports ctypes, which takes 10 ms

    try:
        adapters = list(ifaddr.get_adapters())
    except OSError:  # some systems, such as Android, do not let programs list their interfaces
        return []
    return [str(known.ip) for adapter in adapters for known in adapter.ips if known.is_IPv4]
