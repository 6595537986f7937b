from __future__ import annotations

import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed
from zbot.classroom.errors import ClassValueError
from zbot.classroom.hub.address import Address
from zbot.classroom.join_code import PORTS, decode, long_code, looks_like_code, short_code

if TYPE_CHECKING:
    from collections.abc import Callable

ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
TEACHER = Address("10.77.3.129")


def address_of(text: str, *own: str) -> list[Address]:
    """Return the address of a code; None if the code has a typo."""
    try:
        return decode(text, own)
    except ClassValueError:
        return []


@pytest.mark.parametrize("host", ["10.77.3.129", "192.168.1.10", "172.16.0.1", "10.77.255.255"])
def test_a_short_code_is_resolved_in_the_same_network(host: str) -> None:
    code = short_code(Address(host))
    assert code is not None
    assert len(code) == 4
    assert decode(code, [host]) == [Address(host)]


def test_a_short_code_is_resolved_in_every_network_of_the_laptop() -> None:
    code = short_code(TEACHER) or ""
    assert TEACHER in decode(code, ["172.20.10.2", "10.77.3.7", "192.168.56.1"])


@pytest.mark.parametrize("port", PORTS)
def test_a_long_code_holds_any_address_and_the_usual_ports(port: int) -> None:
    teacher = Address("203.0.113.254", port)
    code = long_code(teacher)
    assert code is not None
    assert decode(code, []) == [teacher]


def test_codes_contain_only_the_usual_ports() -> None:
    assert short_code(Address("10.0.0.1", 443)) is None
    assert long_code(Address("10.0.0.1", 12345)) is None


def test_a_code_needs_an_ipv4_address() -> None:
    with pytest.raises(ClassValueError, match="IPv4"):
        short_code(Address("fe80::1"))


@pytest.mark.parametrize(
    "spelling", [str.lower, lambda code: code.replace("-", " "), "  {} ".format]
)
def test_codes_are_read_in_any_common_spelling(spelling: Callable[[str], str]) -> None:
    code = long_code(TEACHER) or ""
    assert decode(spelling(code), []) == [TEACHER]


def test_letters_that_look_like_digits_are_those_digits() -> None:
    host = "10.0.0.1"  # the code of this address has both digits
    code = short_code(Address(host)) or ""
    assert "0" in code
    assert decode(code.replace("0", "O"), [host]) == [Address(host)]


def test_nearly_every_typo_in_one_character_is_detected() -> None:
    code, own = short_code(TEACHER) or "", TEACHER.host
    typos = [
        code[:place] + char + code[place + 1 :]
        for place in range(4)
        for char in ALPHABET
        if char != code[place]
    ]
    assert sum(bool(address_of(typo, own)) for typo in typos) <= len(typos) / 12


def test_most_pairs_of_swapped_characters_are_detected() -> None:
    code = (long_code(TEACHER) or "").replace("-", "")
    swapped = [
        code[:place] + code[place + 1] + code[place] + code[place + 2 :]
        for place in range(7)
        if code[place] != code[place + 1]
    ]
    assert not any(map(address_of, swapped))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("K7Q", "3 characters"),
        ("K7QXX", "5 characters"),
        ("K7QU", "codes do not contain U"),
        ("K7Q.", "codes do not contain ."),
        ("", "0 characters"),
    ],
)
def test_an_invalid_code_is_refused_with_the_reason(text: str, reason: str) -> None:
    with pytest.raises(ClassValueError, match=reason):
        decode(text, ["10.0.0.1"])


def test_a_code_of_a_megabyte_is_refused_at_once() -> None:
    begin = time.process_time()
    assert address_of("Z" * 1_000_000) == []
    assert time.process_time() - begin < allowed(1)


def test_a_short_code_of_another_network_is_refused_with_a_hint() -> None:
    code = short_code(TEACHER) or ""
    others = [f"{first}.{second}.0.1" for first in (11, 12) for second in range(64)]
    refused = [own for own in others if not address_of(code, own)]
    with pytest.raises(ClassValueError, match="another network than the teacher's"):
        decode(code, refused[:3])


@pytest.mark.parametrize("text", ["K7QX", "k7qx", "K7QX-2M4N", "K7QX2M4N"])
def test_codes_are_recognized(text: str) -> None:
    assert looks_like_code(text)


@pytest.mark.parametrize(
    "text", ["10.0.0.1", "teacher", "beta:7447", "beta.local", "[fe80::1]", ""]
)
def test_addresses_are_not_taken_for_codes(text: str) -> None:
    assert not looks_like_code(text)
