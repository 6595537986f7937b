"""Join code: the address of a class in four or eight characters.

A code needs no name service and no multicast, because it is the address itself in Crockford's
base 32. This alphabet has no I, L, O and U. The decoder reads I and L as 1, and O as 0. Four
characters are enough for laptops whose address begins with the same 16 bits as the teacher's. Eight
characters contain any IPv4 address and one of sixteen ports. The last four bits are a checksum,
which finds most typing errors before a packet is sent.
"""

from __future__ import annotations

import ipaddress
import re
from typing import TYPE_CHECKING

from zbot.classroom.errors import address_error, code_error
from zbot.classroom.hub.address import Address
from zbot.transport.config import HUB_PORT

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Ports that a code can contain, by their index in the code. The default port is first. Then come
#: ports that strict firewalls often allow. The order must not change.
PORTS = (
    HUB_PORT,
    443,
    8447,
    80,
    8080,
    8443,
    *range(7440, 7447),
    7448,
    7449,
    17447,
)

_ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
_VALUES = {char: value for value, char in enumerate(_ALPHABET)} | {"I": 1, "L": 1, "O": 0}
_LOOKS_LIKE_CODE = re.compile(r"[0-9A-Za-z]{4}(?:[- ]?[0-9A-Za-z]{4})?", re.ASCII)
_SHORT, _LONG = 4, 8
_CHECK_BITS = 4
_POLYNOMIAL = 0b10011  # x^4 + x + 1 (CRC-4-ITU) finds every error within four neighbouring bits


def looks_like_code(text: str) -> bool:
    """Return whether a text has the form of a code, and not the form of an address."""
    return _LOOKS_LIKE_CODE.fullmatch(text.strip()) is not None


def short_code(address: Address) -> str | None:
    """Return a code for laptops in the same /16, or `None` if the port is not the default port."""
    if address.port != HUB_PORT:
        return None
    number = _number(address)
    return _text((number & 0xFFFF) << _CHECK_BITS | _short_check(number), _SHORT)


def long_code(address: Address) -> str | None:
    """Return a code `XXXX-XXXX` for any laptop, or `None` if the port is not in `PORTS`."""
    if address.port not in PORTS:
        return None
    payload = _number(address) << 4 | PORTS.index(address.port)
    text = _text(payload << _CHECK_BITS | _check(payload, 36), _LONG)
    return f"{text[:_SHORT]}-{text[_SHORT:]}"


def decode(text: str, own_addresses: Iterable[str]) -> list[Address]:
    """Return the addresses that a code can mean.

    A long code means one address. A short code means at most one address in each network of this
    machine.

    Args:
        text: The code as it was typed, in upper or lower case, with or without its hyphen.
        own_addresses: This machine's IPv4 addresses. Only a short code needs them.

    Raises:
        ClassValueError: The length, a character or the checksum is wrong.
    """
    typed = text.strip().upper().replace("-", "").replace(" ", "")
    invalid = next((char for char in typed if char not in _VALUES), None)
    if invalid is not None:
        raise code_error(text, f"codes do not contain {invalid}")
    if len(typed) not in {_SHORT, _LONG}:
        raise code_error(text, f"it has {len(typed)} characters, but codes have 4 or 8")
    value = 0
    for char in typed:
        value = value << 5 | _VALUES[char]
    if len(typed) == _LONG:
        return [_long_address(text, value)]
    return _short_addresses(text, value, own_addresses)


def _long_address(text: str, value: int) -> Address:
    payload = value >> _CHECK_BITS
    if _check(payload, 36) != value & 0xF:
        raise code_error(text, "a character is wrong")
    return Address(str(ipaddress.IPv4Address(payload >> 4)), PORTS[payload & 0xF])


def _short_addresses(text: str, value: int, own_addresses: Iterable[str]) -> list[Address]:
    prefixes = dict.fromkeys(int(ipaddress.IPv4Address(own)) & 0xFFFF0000 for own in own_addresses)
    numbers = (prefix | value >> _CHECK_BITS for prefix in prefixes)
    found = [number for number in numbers if _short_check(number) == value & 0xF]
    if not found:
        raise code_error(
            text,
            "a character is wrong, or this machine is in another network than the teacher's (then "
            "use the teacher's address)",
        )
    return [Address(str(ipaddress.IPv4Address(number))) for number in found]


def _number(address: Address) -> int:
    try:
        return int(ipaddress.IPv4Address(address.host))
    except ValueError as exc:
        raise address_error(address.host, "a code requires an IPv4 address") from exc


def _short_check(number: int) -> int:
    return _check(number << 16 | HUB_PORT, 48)


def _check(payload: int, bits: int) -> int:
    """Return the remainder of a division by the polynomial over GF(2)."""
    value = payload << _CHECK_BITS
    for position in range(bits + _CHECK_BITS - 1, _CHECK_BITS - 1, -1):
        if value >> position & 1:
            value ^= _POLYNOMIAL << position - _CHECK_BITS
    return value


def _text(value: int, length: int) -> str:
    return "".join(_ALPHABET[value >> 5 * place & 31] for place in range(length - 1, -1, -1))
