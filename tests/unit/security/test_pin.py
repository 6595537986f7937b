from __future__ import annotations

import json
import subprocess
import sys
import time
from typing import Any

import pytest

from zbot.security.key_exchange import exchange_s
from zbot.security.pin import (
    PROTOCOL,
    PinClient,
    PinError,
    PinMessageError,
    PinServer,
    TooManyGuessesError,
    WrongPinError,
    random_pin,
)
from zbot.security.secret import Secret

PIN = Secret("471100")
NAME = "Robots"
HUB = "tcp/10.0.0.1:7447"
POINT = "5866666666666666666666666666666666666666666666666666666666666666"
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
    return make_server(PIN, clock)


def make_server(pin: Secret, clock: Clock | None = None) -> PinServer:
    return PinServer(pin, NAME, lambda hub: hub == HUB, clock or Clock(), lambda _s: None)


def make_client(pin: Secret = PIN, name: str = NAME, hub: str = HUB) -> PinClient:
    return PinClient(pin, name, hub)


def claim(server: PinServer, pin: Secret = PIN, client: PinClient | None = None) -> dict[str, Any]:
    client = client or make_client(pin)
    return client.claim(server.challenge(client.hello()), REQUEST)


def test_a_client_with_the_pin_is_admitted_and_only_it_reads_the_answer(server: PinServer) -> None:
    client = make_client()
    admission = server.admit(claim(server, client=client))
    assert admission.request == REQUEST
    sealed = admission.seal({"secret": "0123456789abcdef" * 5})
    assert client.opened(sealed) == {"secret": "0123456789abcdef" * 5}
    assert b"0123456789abcdef" not in bytes.fromhex(sealed["answer"])
    other = make_client()
    with pytest.raises(PinMessageError, match="before the claim"):
        other.opened(sealed)
    claim(server, client=other)
    with pytest.raises(PinMessageError, match="does not know it"):
        other.opened(sealed)


def test_two_answers_to_one_claim_have_no_bytes_in_common(server: PinServer) -> None:
    client = make_client()
    admission = server.admit(claim(server, client=client))
    first, second = (admission.seal({"secret": "s3cret"}) for _ in range(2))
    pairs = zip(bytes.fromhex(first["answer"]), bytes.fromhex(second["answer"]), strict=True)
    assert sum(one == other for one, other in pairs) < 10  # about one of 45 by chance
    assert client.opened(first) == client.opened(second) == {"secret": "s3cret"}


def test_blanks_around_a_typed_pin_do_not_matter(server: PinServer) -> None:
    assert server.admit(claim(server, Secret(" 471100\n"))).request == REQUEST


def test_another_pin_is_refused_and_counted(server: PinServer) -> None:
    with pytest.raises(WrongPinError, match="wrong PIN"):
        server.admit(claim(server, Secret("471101")))
    assert server.wrong == 1


def test_messages_reveal_neither_the_pin_nor_what_is_said() -> None:
    # Random bytes and their hexadecimal digits cannot contain words of this length by chance.
    pin = Secret("pin 471100")
    server, client = make_server(pin), make_client(pin)
    said = [client.hello()]
    said += [server.challenge(said[0])]
    said += [client.claim(said[1], {"name": "Anastasia"})]
    said += [server.admit(said[2]).seal({"secret": "s3cret"})]
    text = json.dumps(said)
    carried = bytes.fromhex(said[2]["claim"]) + bytes.fromhex(said[3]["answer"])
    for word in (pin.reveal(), "s3cret", "Anastasia"):
        assert word not in text
        assert word.encode() not in carried


def test_a_recorded_claim_is_refused(server: PinServer) -> None:
    recorded = claim(server)
    server.admit(recorded)
    with pytest.raises(PinMessageError, match="tried twice"):
        server.admit(recorded)
    later = make_client()
    attempt = server.challenge(later.hello())["visit"]
    with pytest.raises(WrongPinError):
        server.admit(recorded | {"visit": attempt})


def test_the_time_of_a_reply_does_not_depend_on_the_pin(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("zbot.security.pin.exchange_s", lambda: 60.0)
    slept: list[float] = []
    server = PinServer(PIN, NAME, lambda _hub: True, sleep=slept.append)
    begun = time.perf_counter()
    prepared = claim(server)
    assert 60 - (time.perf_counter() - begun) <= slept[0] < 60
    begun = time.perf_counter()
    server.admit(prepared)
    assert 60 - (time.perf_counter() - begun) <= slept[1] < 60
    with pytest.raises(PinError):
        server.admit(claim(server) | {"proof": "00" * 32})
    assert len(slept) == 4


def test_the_time_of_a_reply_is_longer_than_an_exchange_takes() -> None:
    assert 0 < exchange_s() <= 0.1


def test_an_attempt_expires(server: PinServer, clock: Clock) -> None:
    late = claim(server)
    clock.now += 31
    with pytest.raises(PinMessageError, match="too long"):
        server.admit(late)


def test_a_hub_without_the_pin_cannot_impersonate_the_teacher() -> None:
    client = make_client()
    impostor = make_server(Secret("000000"))
    with pytest.raises(WrongPinError):
        impostor.admit(claim(impostor, client=client))
    with pytest.raises(PinMessageError, match="sender of the answer does not know it"):
        client.opened({"answer": "00" * 40, "tag": "00" * 32})


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
    for given in prepared:
        with pytest.raises(PinError):
            server.admit(given)
    assert server.wrong == 10


def test_the_right_pin_does_not_count_as_a_guess(server: PinServer) -> None:
    for _ in range(30):
        server.admit(claim(server))


def test_forty_laptops_can_join_at_once(server: PinServer) -> None:
    claims = [claim(server) for _ in range(40)]
    assert all(server.admit(prepared_claim).request == REQUEST for prepared_claim in claims)


BAD_TEXTS = [None, 5, "", "41", "xyz", ["1"], {"a": 1}, "f" * 1_000_000, "\ud800", "é" * 66]


@pytest.mark.parametrize("field", ["public", "hub"])
@pytest.mark.parametrize("bad", BAD_TEXTS, ids=lambda bad: str(bad)[:9].encode("ascii", "replace"))
def test_an_invalid_hello_is_refused(server: PinServer, field: str, bad: object) -> None:
    with pytest.raises((PinMessageError, PinError)):
        server.challenge(make_client().hello() | {field: bad})
    with pytest.raises(PinMessageError):
        server.challenge({})


@pytest.mark.parametrize(
    "point",
    [
        "00" * 32,  # order 4
        "01" + "00" * 31,  # the neutral element
        "ec" + "ff" * 30 + "7f",  # order 2
        "c7176a703d4dd84fba3c0b760d10670f2a2053fa2c39ccc64ec7fd7792ac037a",  # order 8
        "02" + "00" * 31,  # not on the curve
        "ff" * 32,
    ],
)
def test_a_point_that_would_reveal_the_key_is_refused(server: PinServer, point: str) -> None:
    _check_public_is_refused(server, "41" + point, "42" + point)


@pytest.mark.parametrize(("of_laptop", "of_class"), [("42", "41"), ("53", "53"), ("00", "00")])
def test_a_number_of_the_wrong_side_is_refused(
    server: PinServer, of_laptop: str, of_class: str
) -> None:
    _check_public_is_refused(server, of_laptop + POINT, of_class + POINT)


def _check_public_is_refused(server: PinServer, of_laptop: str, of_class: str) -> None:
    client = make_client()
    challenge = server.challenge(client.hello() | {"public": of_laptop})
    with pytest.raises(PinMessageError):
        server.admit(client.claim(challenge, REQUEST))
    with pytest.raises(PinMessageError):
        make_client().claim(challenge | {"public": of_class}, REQUEST)


def test_a_reflected_number_is_refused() -> None:
    client = make_client()
    reflected = "42" + client.hello()["public"][2:]
    challenge = {"protocol": PROTOCOL, "visit": "00" * 16, "public": reflected}
    with pytest.raises(PinMessageError):
        client.claim(challenge, REQUEST)


@pytest.mark.parametrize("field", ["visit", "claim", "proof"])
@pytest.mark.parametrize("bad", BAD_TEXTS, ids=lambda bad: str(bad)[:9].encode("ascii", "replace"))
def test_an_invalid_claim_is_refused_and_is_no_guess(
    server: PinServer, field: str, bad: object
) -> None:
    for _ in range(11):
        with pytest.raises(PinMessageError):
            server.admit(RECORDED | {field: bad})
    with pytest.raises(PinMessageError):
        server.admit({})


RECORDED = {"visit": "00" * 16, "claim": "00" * 60, "proof": "00" * 32}


@pytest.mark.parametrize("field", ["visit", "public"])
@pytest.mark.parametrize("bad", BAD_TEXTS, ids=lambda bad: str(bad)[:9].encode("ascii", "replace"))
def test_a_client_refuses_an_invalid_challenge(server: PinServer, field: str, bad: object) -> None:
    client = make_client()
    with pytest.raises(PinMessageError):
        client.claim(server.challenge(client.hello()) | {field: bad}, REQUEST)
    with pytest.raises(PinMessageError):
        client.claim({}, REQUEST)


@pytest.mark.parametrize("bad", [None, "2", 2.0, True, 0, -1, [2], float("nan")], ids=str)
def test_an_invalid_version_is_refused(server: PinServer, bad: object) -> None:
    hello = make_client().hello()
    with pytest.raises(PinMessageError):
        server.challenge(hello | {"protocol": bad})
    with pytest.raises(PinMessageError):
        make_client().claim(server.challenge(hello) | {"protocol": bad}, REQUEST)


@pytest.mark.parametrize(("difference", "older"), [(-1, "this laptop"), (1, "the class")])
def test_a_class_says_who_is_older(server: PinServer, difference: int, older: str) -> None:
    hello = make_client().hello() | {"protocol": PROTOCOL + difference}
    with pytest.raises(PinError, match=f"^zbot (on|of) {older} is older"):
        server.challenge(hello)


@pytest.mark.parametrize(("difference", "older"), [(-1, "the class"), (1, "this laptop")])
def test_a_laptop_says_who_is_older(server: PinServer, difference: int, older: str) -> None:
    challenge = server.challenge(make_client().hello()) | {"protocol": PROTOCOL + difference}
    with pytest.raises(PinError, match=f"^zbot (on|of) {older} is older"):
        make_client().claim(challenge, REQUEST)


def test_documents_of_the_first_version_are_recognized(server: PinServer) -> None:
    with pytest.raises(PinError, match="on this laptop is older"):
        server.challenge({"public": "ab" * 384})
    with pytest.raises(PinError, match="of the class is older"):
        make_client().claim({"visit": "00" * 16, "salt": "00", "public": "ab" * 384}, REQUEST)


def test_a_request_that_is_too_long_is_not_sent(server: PinServer) -> None:
    client = make_client()
    challenge = server.challenge(client.hello())
    with pytest.raises(PinMessageError, match="too long"):
        client.claim(challenge, {"name": "x" * 100_000})


@pytest.mark.parametrize(
    "pin", ["", "x" * 100_000, "é\ud800", "\0"], ids=["empty", "long", "é", "0"]
)
def test_any_text_can_be_a_pin(pin: str) -> None:
    server = make_server(Secret(pin))
    assert server.admit(claim(server, Secret(pin))).request == REQUEST


def test_only_an_exchange_imports_the_libraries() -> None:
    program = "import sys, zbot, zbot.classroom.student.joining, zbot_cli.main\n"
    program += "print([name for name in sys.modules if name in {'spake2', 'cryptography'}])"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    assert done.stdout.split() == [b"[]"]


def test_nothing_shows_the_keys(server: PinServer) -> None:
    client = make_client()
    admission = server.admit(claim(server, client=client))
    assert "_shared" not in repr(admission)
    assert "_shared" not in repr(client._keys)


def test_a_random_pin_has_six_digits() -> None:
    pins = {random_pin().reveal() for _ in range(50)}
    assert len(pins) > 40
    assert all(len(pin) == 6 and pin.isdigit() for pin in pins)
