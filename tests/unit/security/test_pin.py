from __future__ import annotations

import json
from typing import Any

import pytest

from zbot.security.pin import (
    PinClient,
    PinError,
    PinMessageError,
    PinServer,
    TooManyGuessesError,
    WrongPinError,
    random_pin,
)
from zbot.security.secret import Secret
from zbot.security.srp import GROUP

PIN = Secret("471100")
WISH = {"name": "Ana", "number": 17}


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def door(clock: Clock) -> PinServer:
    return PinServer(PIN, clock)


def claim(door: PinServer, pin: Secret = PIN, guest: PinClient | None = None) -> dict[str, Any]:
    guest = guest or PinClient(pin)
    return guest.claim(door.challenge(guest.hello()), WISH)


def test_who_knows_the_pin_is_let_in_and_alone_reads_the_answer(door: PinServer) -> None:
    guest = PinClient(PIN)
    admission = door.admit(claim(door, guest=guest))
    assert admission.wish == WISH
    sealed = admission.seal({"secret": "0123456789abcdef" * 5})
    assert guest.opened(sealed) == {"secret": "0123456789abcdef" * 5}
    assert b"0123456789abcdef" not in bytes.fromhex(sealed["answer"])
    with pytest.raises(PinMessageError):
        PinClient(PIN).opened(sealed)


def test_blanks_around_a_typed_pin_do_not_matter(door: PinServer) -> None:
    assert door.admit(claim(door, Secret(" 471100\n"))).wish == WISH


def test_another_pin_is_refused_and_counted(door: PinServer) -> None:
    with pytest.raises(WrongPinError, match="wrong PIN"):
        door.admit(claim(door, Secret("471101")))
    assert door.wrong == 1


def test_neither_pin_nor_wrong_pin_can_be_read_on_the_way(door: PinServer) -> None:
    guest = PinClient(PIN)
    said = [guest.hello()]
    said += [door.challenge(said[0])]
    said += [guest.claim(said[1], WISH)]
    said += [door.admit(said[2]).seal({"secret": "s3cret"})]
    text = json.dumps(said)
    carried = bytes.fromhex(said[2]["claim"]) + bytes.fromhex(said[3]["answer"])
    for word in ("471100", "s3cret", "Ana"):
        assert word not in text
        assert word.encode() not in carried


def test_a_recorded_claim_is_worth_nothing(door: PinServer) -> None:
    recorded = claim(door)
    door.admit(recorded)
    with pytest.raises(PinMessageError, match="tried twice"):
        door.admit(recorded)
    later = PinClient(PIN)
    visit = door.challenge(later.hello())["visit"]
    with pytest.raises(WrongPinError):
        door.admit(recorded | {"visit": visit})


def test_a_claim_that_was_changed_on_the_way_is_refused(door: PinServer) -> None:
    honest = claim(door)
    flipped = bytearray.fromhex(honest["claim"])
    flipped[-3] ^= 1
    changed = honest | {"claim": flipped.hex()}
    with pytest.raises(WrongPinError):
        door.admit(changed)


def test_a_visit_ends_after_a_while(door: PinServer, clock: Clock) -> None:
    late = claim(door)
    clock.now += 31
    with pytest.raises(PinMessageError, match="too long"):
        door.admit(late)


def test_who_does_not_know_the_pin_cannot_play_the_teacher() -> None:
    guest = PinClient(PIN)
    rogue = PinServer(Secret("000000"))
    with pytest.raises(WrongPinError):
        rogue.admit(claim(rogue, guest=guest))
    with pytest.raises(PinMessageError, match="somebody who knows it"):
        guest.opened({"answer": "00" * 40, "tag": "0" * 64})


def test_guessing_is_slowed_down_and_a_student_gets_in_again(door: PinServer, clock: Clock) -> None:
    for number in range(10):
        with pytest.raises(WrongPinError):
            door.admit(claim(door, Secret(f"{number:06d}")))
    with pytest.raises(TooManyGuessesError) as caught:
        claim(door)
    assert 0 < caught.value.wait_s <= 2
    clock.now += 2
    assert door.admit(claim(door)).wish == WISH


def test_a_minute_of_guessing_is_worth_forty_guesses_at_most(door: PinServer, clock: Clock) -> None:
    for _ in range(60):
        clock.now += 1
        with pytest.raises((WrongPinError, TooManyGuessesError)):
            door.admit(claim(door, Secret("0")))
    assert door.wrong <= 40


def test_guesses_prepared_at_once_count_each(door: PinServer) -> None:
    prepared = [claim(door, Secret(f"{number:06d}")) for number in range(30)]
    for one in prepared:
        with pytest.raises(PinError):
            door.admit(one)
    assert door.wrong == 10


def test_the_right_pin_costs_no_guess(door: PinServer) -> None:
    for _ in range(30):
        door.admit(claim(door))


def test_a_class_that_joins_at_once_gets_in(door: PinServer) -> None:
    claims = [claim(door) for _ in range(40)]
    assert all(door.admit(one).wish == WISH for one in claims)


@pytest.mark.parametrize(
    "hello",
    [
        {},
        {"public": None},
        {"public": 5},
        {"public": "0"},
        {"public": "-1"},
        {"public": f"{GROUP.prime:x}"},
        {"public": f"{2 * GROUP.prime:x}"},
        {"public": "f" * 1_000_000},
        {"public": "xyz"},
        {"public": ["1"]},
    ],
    ids=lambda hello: str(hello)[:24],
)
def test_nonsense_for_a_first_word_is_refused(door: PinServer, hello: dict[str, Any]) -> None:
    with pytest.raises(PinMessageError):
        door.challenge(hello)


@pytest.mark.parametrize("changed", [{"visit": "x"}, {"visit": 3}, {"claim": "\ud800"}])
def test_a_claim_without_a_visit_is_refused(door: PinServer, changed: dict[str, Any]) -> None:
    with pytest.raises(PinMessageError):
        door.admit(claim(door) | changed)


@pytest.mark.parametrize(
    "changed", [{"proof": "é"}, {"proof": 3}, {"proof": None}, {"claim": "00"}]
)
def test_a_claim_without_a_proof_is_refused(door: PinServer, changed: dict[str, Any]) -> None:
    with pytest.raises(WrongPinError):
        door.admit(claim(door) | changed)


@pytest.mark.parametrize(
    "challenge",
    [{}, {"public": "0", "salt": "00"}, {"public": "5", "salt": "x"}, {"public": "5"}],
)
def test_a_student_refuses_a_senseless_challenge(challenge: dict[str, Any]) -> None:
    with pytest.raises(PinMessageError):
        PinClient(PIN).claim(challenge, WISH)


def test_a_random_pin_has_six_digits() -> None:
    pins = {random_pin().reveal() for _ in range(50)}
    assert len(pins) > 40
    assert all(len(pin) == 6 and pin.isdigit() for pin in pins)
