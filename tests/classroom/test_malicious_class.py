"""What a laptop makes of answers that no class of ours would give."""

from __future__ import annotations

import json
import threading
from typing import TYPE_CHECKING, Any

import pytest

from tests.classroom.talk import HERE, free_port, open_session
from zbot.classroom.address import Address
from zbot.classroom.admission import AdmissionRequest
from zbot.classroom.enrolment import knock
from zbot.classroom.errors import NoHubError, RefusedError
from zbot.classroom.keys import DOOR_KEY
from zbot.security.pin import PinMessageError, PinServer
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import zenoh

    Answer = Callable[[dict[str, Any]], dict[str, Any]]

PIN = Secret("471100")


@pytest.fixture
def rogue(monkeypatch: pytest.MonkeyPatch, tmp_path: Any) -> Iterator[Callable[[Answer], Address]]:
    """Return a function that opens a hub whose door gives the answers of a function."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    opened: list[zenoh.Session] = []

    def start(answer: Answer) -> Address:
        port = free_port()
        where = {"mode": "router", "listen/endpoints": [f"tcp/{HERE}:{port}"]}
        opened.append(open_session(where))

        def reply(query: zenoh.Query) -> None:
            assert query.payload is not None
            question = json.loads(query.payload.to_bytes())
            query.reply(DOOR_KEY, json.dumps(answer(question)))

        opened[-1].declare_queryable(DOOR_KEY, reply, complete=True)
        return Address(HERE, port)

    yield start
    for session in opened:
        session.close()


def knock_at(address: Address) -> None:
    knock(address, AdmissionRequest("machine", "host"), lambda _name: PIN.reveal())


HELLO = {"class": "x", "pin": True}


@pytest.mark.parametrize(
    "challenge",
    [{}, {"salt": 1, "public": 2}, {"wait_s": float("nan")}, {"wait_s": 1e9}, {"wait_s": "x"}],
    ids=str,
)
def test_a_senseless_challenge_is_a_sentence(
    rogue: Callable[[Answer], Address], challenge: dict[str, Any]
) -> None:
    address = rogue(lambda question: HELLO if question["op"] == "hello" else challenge)
    with pytest.raises(PinMessageError):
        knock_at(address)


def test_a_class_that_does_not_know_the_pin_hands_out_nothing(
    rogue: Callable[[Answer], Address],
) -> None:
    door = PinServer(Secret("000000"))
    seen = threading.Event()

    def answer(question: dict[str, Any]) -> dict[str, Any]:
        if question["op"] == "claim":
            seen.set()
            return {"answer": "00" * 40, "tag": "0" * 64}
        return HELLO if question["op"] == "hello" else door.challenge(question)

    with pytest.raises(PinMessageError, match="somebody who knows it"):
        knock_at(rogue(answer))
    assert seen.is_set()


def test_a_membership_that_makes_no_sense_is_refused(
    rogue: Callable[[Answer], Address],
) -> None:
    door = PinServer(PIN)

    def answer(question: dict[str, Any]) -> dict[str, Any]:
        if question["op"] == "claim":
            return door.admit(question).seal({"number": "many"})
        return HELLO if question["op"] == "hello" else door.challenge(question)

    with pytest.raises(NoHubError):
        knock_at(rogue(answer))


def test_a_refusal_is_shown_without_what_moves_cursors(
    rogue: Callable[[Answer], Address],
) -> None:
    with pytest.raises(RefusedError) as caught:
        knock_at(rogue(lambda _question: {"refused": "x", "sentence": "\x1b[2Jgone\r\n"} | HELLO))
    assert str(caught.value).isprintable()
