from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.classroom.address import Address
from zbot.classroom.errors import AddressError, CodeError
from zbot.classroom.join_code import PORTS, decode, long_code, looks_like_code, short_code

if TYPE_CHECKING:
    from collections.abc import Callable

ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
TEACHER = Address("10.77.3.129")


def leads_to(text: str, *own: str) -> list[Address]:
    """Return where a code leads to; nowhere if it has a typo."""
    try:
        return decode(text, own)
    except CodeError:
        return []


@pytest.mark.parametrize("host", ["10.77.3.129", "192.168.1.10", "172.16.0.1", "10.77.255.255"])
def test_a_short_code_leads_to_the_teacher_from_the_same_network(host: str) -> None:
    code = short_code(Address(host))
    assert code is not None
    assert len(code) == 4
    assert decode(code, [host]) == [Address(host)]


def test_a_short_code_is_looked_for_in_every_network_of_the_laptop() -> None:
    code = short_code(TEACHER) or ""
    assert TEACHER in decode(code, ["172.20.10.2", "10.77.3.7", "192.168.56.1"])


@pytest.mark.parametrize("port", PORTS)
def test_a_long_code_holds_any_address_and_the_usual_ports(port: int) -> None:
    teacher = Address("203.0.113.254", port)
    code = long_code(teacher)
    assert code is not None
    assert decode(code, []) == [teacher]


def test_codes_hold_no_port_but_the_usual_ones() -> None:
    assert short_code(Address("10.0.0.1", 443)) is None
    assert long_code(Address("10.0.0.1", 12345)) is None


def test_a_code_needs_an_ipv4_address() -> None:
    with pytest.raises(AddressError, match="IPv4"):
        short_code(Address("fe80::1"))


@pytest.mark.parametrize(
    "spelling", [str.lower, lambda code: code.replace("-", " "), "  {} ".format]
)
def test_codes_are_read_as_people_write_them(spelling: Callable[[str], str]) -> None:
    code = long_code(TEACHER) or ""
    assert decode(spelling(code), []) == [TEACHER]


def test_letters_that_look_like_digits_are_those_digits() -> None:
    host = "10.0.0.1"  # its code has both digits
    code = short_code(Address(host)) or ""
    assert "0" in code
    assert decode(code.replace("0", "O"), [host]) == [Address(host)]


def test_hardly_any_typo_in_one_character_leads_elsewhere() -> None:
    code, own = short_code(TEACHER) or "", TEACHER.host
    typos = [
        code[:place] + char + code[place + 1 :]
        for place in range(4)
        for char in ALPHABET
        if char != code[place]
    ]
    assert sum(bool(leads_to(typo, own)) for typo in typos) <= len(typos) / 12


def test_most_pairs_of_swapped_characters_are_found_out() -> None:
    code = (long_code(TEACHER) or "").replace("-", "")
    swapped = [
        code[:place] + code[place + 1] + code[place] + code[place + 2 :]
        for place in range(7)
        if code[place] != code[place + 1]
    ]
    assert not any(map(leads_to, swapped))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("K7Q", "3 characters"),
        ("K7QXX", "5 characters"),
        ("K7QU", "no code has a U"),
        ("K7Q.", "no code has a ."),
        ("", "0 characters"),
    ],
)
def test_what_cannot_be_a_code_says_why(text: str, reason: str) -> None:
    with pytest.raises(CodeError, match=reason):
        decode(text, ["10.0.0.1"])


def test_a_short_code_from_another_network_says_that_it_may_be_right() -> None:
    code = short_code(TEACHER) or ""
    others = [f"{first}.{second}.0.1" for first in (11, 12) for second in range(64)]
    refused = [own for own in others if not leads_to(code, own)]
    with pytest.raises(CodeError, match="another network than the teacher's"):
        decode(code, refused[:3])


@pytest.mark.parametrize("text", ["K7QX", "k7qx", "K7QX-2M4N", "K7QX2M4N"])
def test_codes_are_told_from_addresses(text: str) -> None:
    assert looks_like_code(text)


@pytest.mark.parametrize(
    "text", ["10.0.0.1", "teacher", "beta:7447", "beta.local", "[fe80::1]", ""]
)
def test_addresses_are_told_from_codes(text: str) -> None:
    assert not looks_like_code(text)
