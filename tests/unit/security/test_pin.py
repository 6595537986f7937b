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
REQUEST = {"name": "Ana", "number": 17}


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def server(clock: Clock) -> PinServer:
    return PinServer(PIN, clock)


def claim(server: PinServer, pin: Secret = PIN, client: PinClient | None = None) -> dict[str, Any]:
    client = client or PinClient(pin)
    return client.claim(server.challenge(client.hello()), REQUEST)


def test_a_client_with_the_pin_is_admitted_and_only_it_reads_the_answer(server: PinServer) -> None:
    client = PinClient(PIN)
    admission = server.admit(claim(server, client=client))
    assert admission.request == REQUEST
    sealed = admission.seal({"secret": "0123456789abcdef" * 5})
    assert client.opened(sealed) == {"secret": "0123456789abcdef" * 5}
    assert b"0123456789abcdef" not in bytes.fromhex(sealed["answer"])
    with pytest.raises(PinMessageError):
        PinClient(PIN).opened(sealed)


def test_blanks_around_a_typed_pin_do_not_matter(server: PinServer) -> None:
    assert server.admit(claim(server, Secret(" 471100\n"))).request == REQUEST


def test_another_pin_is_refused_and_counted(server: PinServer) -> None:
    with pytest.raises(WrongPinError, match="wrong PIN"):
        server.admit(claim(server, Secret("471101")))
    assert server.wrong == 1


def test_messages_reveal_neither_the_pin_nor_a_wrong_pin(server: PinServer) -> None:
    client = PinClient(PIN)
    said = [client.hello()]
    said += [server.challenge(said[0])]
    said += [client.claim(said[1], REQUEST)]
    said += [server.admit(said[2]).seal({"secret": "s3cret"})]
    text = json.dumps(said)
    carried = bytes.fromhex(said[2]["claim"]) + bytes.fromhex(said[3]["answer"])
    for word in ("471100", "s3cret", "Ana"):
        assert word not in text
        assert word.encode() not in carried


def test_a_recorded_claim_is_refused(server: PinServer) -> None:
    recorded = claim(server)
    server.admit(recorded)
    with pytest.raises(PinMessageError, match="tried twice"):
        server.admit(recorded)
    later = PinClient(PIN)
    attempt = server.challenge(later.hello())["visit"]
    with pytest.raises(WrongPinError):
        server.admit(recorded | {"visit": attempt})


def test_a_modified_claim_is_refused(server: PinServer) -> None:
    honest = claim(server)
    flipped = bytearray.fromhex(honest["claim"])
    flipped[-3] ^= 1
    changed = honest | {"claim": flipped.hex()}
    with pytest.raises(WrongPinError):
        server.admit(changed)


def test_an_attempt_expires(server: PinServer, clock: Clock) -> None:
    late = claim(server)
    clock.now += 31
    with pytest.raises(PinMessageError, match="too long"):
        server.admit(late)


def test_a_hub_without_the_pin_cannot_impersonate_the_teacher() -> None:
    client = PinClient(PIN)
    impostor = PinServer(Secret("000000"))
    with pytest.raises(WrongPinError):
        impostor.admit(claim(impostor, client=client))
    with pytest.raises(PinMessageError, match="sender of the answer does not know it"):
        client.opened({"answer": "00" * 40, "tag": "0" * 64})


def test_guesses_are_rate_limited_and_a_student_can_join_again(
    server: PinServer, clock: Clock
) -> None:
    for number in range(10):
        with pytest.raises(WrongPinError):
            server.admit(claim(server, Secret(f"{number:06d}")))
    with pytest.raises(TooManyGuessesError) as caught:
        claim(server)
    assert 0 < caught.value.wait_s <= 2
    clock.now += 2
    assert server.admit(claim(server)).request == REQUEST


def test_at_most_forty_guesses_per_minute_are_possible(server: PinServer, clock: Clock) -> None:
    for _ in range(60):
        clock.now += 1
        with pytest.raises((WrongPinError, TooManyGuessesError)):
            server.admit(claim(server, Secret("0")))
    assert server.wrong <= 40


def test_guesses_prepared_at_once_count_each(server: PinServer) -> None:
    prepared = [claim(server, Secret(f"{number:06d}")) for number in range(30)]
    for one in prepared:
        with pytest.raises(PinError):
            server.admit(one)
    assert server.wrong == 10


def test_the_right_pin_does_not_count_as_a_guess(server: PinServer) -> None:
    for _ in range(30):
        server.admit(claim(server))


def test_forty_laptops_can_join_at_once(server: PinServer) -> None:
    claims = [claim(server) for _ in range(40)]
    assert all(server.admit(one).request == REQUEST for one in claims)


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
def test_an_invalid_hello_is_refused(server: PinServer, hello: dict[str, Any]) -> None:
    with pytest.raises(PinMessageError):
        server.challenge(hello)


@pytest.mark.parametrize("changed", [{"visit": "x"}, {"visit": 3}, {"claim": "\ud800"}])
def test_a_claim_without_an_attempt_is_refused(server: PinServer, changed: dict[str, Any]) -> None:
    with pytest.raises(PinMessageError):
        server.admit(claim(server) | changed)


@pytest.mark.parametrize(
    "changed", [{"proof": "é"}, {"proof": 3}, {"proof": None}, {"claim": "00"}]
)
def test_a_claim_without_a_proof_is_refused(server: PinServer, changed: dict[str, Any]) -> None:
    with pytest.raises(WrongPinError):
        server.admit(claim(server) | changed)


@pytest.mark.parametrize(
    "challenge",
    [{}, {"public": "0", "salt": "00"}, {"public": "5", "salt": "x"}, {"public": "5"}],
)
def test_a_client_refuses_an_invalid_challenge(challenge: dict[str, Any]) -> None:
    with pytest.raises(PinMessageError):
        PinClient(PIN).claim(challenge, REQUEST)


def test_a_random_pin_has_six_digits() -> None:
    pins = {random_pin().reveal() for _ in range(50)}
    assert len(pins) > 40
    assert all(len(pin) == 6 and pin.isdigit() for pin in pins)
