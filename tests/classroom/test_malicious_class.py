"""Laptops that join a class with invalid or malicious replies."""

from __future__ import annotations

import json
import threading
from typing import TYPE_CHECKING, Any

import pytest

from tests.classroom.talk import HERE, free_port, open_session
from zbot.classroom.errors import NoHubError, RefusedError
from zbot.classroom.hub.address import Address
from zbot.classroom.join_request import JoinRequest
from zbot.classroom.keys import ADMISSION_KEY
from zbot.classroom.student.lobby import request_membership
from zbot.security.pin import PinMessageError, PinServer
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import zenoh

    Answer = Callable[[dict[str, Any]], dict[str, Any]]

PIN = Secret("471100")


@pytest.fixture
def malicious_hub(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Any
) -> Iterator[Callable[[Answer], Address]]:
    """Return a function that opens a hub which answers admission queries with a given function."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    opened: list[zenoh.Session] = []

    def start(answer: Answer) -> Address:
        port = free_port()
        where = {"mode": "router", "listen/endpoints": [f"tcp/{HERE}:{port}"]}
        opened.append(open_session(where))

        def reply(query: zenoh.Query) -> None:
            assert query.payload is not None
            question = json.loads(query.payload.to_bytes())
            query.reply(ADMISSION_KEY, json.dumps(answer(question)))

        opened[-1].declare_queryable(ADMISSION_KEY, reply, complete=True)
        return Address(HERE, port)

    yield start
    for session in opened:
        session.close()


def request_from(address: Address) -> None:
    request_membership(address, JoinRequest("machine", "host"), lambda _name: PIN.reveal())


HELLO = {"class": "x", "pin": True}


@pytest.mark.parametrize(
    "challenge",
    [
        {},
        {"visit": 1, "public": 2, "protocol": 2},
        {"wait_s": float("nan")},
        {"wait_s": 1e9},
        {"wait_s": "x"},
    ],
    ids=str,
)
def test_an_invalid_challenge_raises_a_pin_error(
    malicious_hub: Callable[[Answer], Address], challenge: dict[str, Any]
) -> None:
    address = malicious_hub(lambda question: HELLO if question["op"] == "hello" else challenge)
    with pytest.raises(PinMessageError):
        request_from(address)


def test_a_class_that_does_not_know_the_pin_is_rejected(
    malicious_hub: Callable[[Answer], Address],
) -> None:
    server = PinServer(Secret("000000"), "x", lambda _hub: True)
    seen = threading.Event()

    def answer(question: dict[str, Any]) -> dict[str, Any]:
        if question["op"] == "claim":
            seen.set()
            return {"answer": "00" * 40, "tag": "00" * 32}
        return HELLO if question["op"] == "hello" else server.challenge(question)

    with pytest.raises(PinMessageError, match="sender of the answer does not know it"):
        request_from(malicious_hub(answer))
    assert seen.is_set()


def test_an_invalid_membership_is_rejected(malicious_hub: Callable[[Answer], Address]) -> None:
    server = PinServer(PIN, "x", lambda _hub: True)

    def answer(question: dict[str, Any]) -> dict[str, Any]:
        if question["op"] == "claim":
            return server.admit(question).seal({"number": "many"})
        return HELLO if question["op"] == "hello" else server.challenge(question)

    with pytest.raises(NoHubError):
        request_from(malicious_hub(answer))


def test_a_refusal_is_shown_without_control_characters(
    malicious_hub: Callable[[Answer], Address],
) -> None:
    with pytest.raises(RefusedError) as caught:
        request_from(
            malicious_hub(lambda _question: {"refused": "x", "sentence": "\x1b[2Jgone\r\n"} | HELLO)
        )
    assert str(caught.value).isprintable()
