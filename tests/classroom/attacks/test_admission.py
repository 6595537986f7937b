"""Attacks on the admission to a class: numbers and PINs."""

from __future__ import annotations

import json
import time

import pytest
import zenoh

from tests.classroom.attacked import PIN, AttackedClass, pin_client
from tests.classroom.attacks.conftest import asked, claimed
from tests.classroom.recording_proxy import RecordingProxy
from tests.classroom.talk import HERE, accepts, dialling, open_session
from tests.conftest import wait_until
from zbot.classroom.keys import ADMISSION_KEY


def test_claim_a_taken_number(room: AttackedClass) -> None:
    eve = room.computer("eve1")
    refused = eve.run("join", f"{HERE}:{room.port}", "--number", "17", ZBOT_PIN=PIN)
    assert refused.code == 1
    assert refused.err.startswith("number 17 is taken by Ana: choose another")
    assert not eve.has_joined


def test_claim_a_number_with_the_name_of_its_owner(lobby_user: zenoh.Session) -> None:
    for request in (
        {"machine": "eve", "host": "x", "number": 17, "name": "Ana"},
        {"machine": "", "host": "x", "number": 17, "name": "Ana"},
        {"host": "x", "number": 17},
    ):
        answer = claimed(lobby_user, PIN, request)["answer"]
        assert answer["refused"] == "taken"
        assert "secret" not in json.dumps(answer)


def test_replay_a_claim(lobby_user: zenoh.Session) -> None:
    request = {"machine": "carl", "host": "carl-laptop", "number": 30}
    recorded = claimed(lobby_user, PIN, request)
    assert "tag" in recorded["answer"]
    again = asked(lobby_user, recorded["claim"])
    assert again["refused"] == "question"
    later = asked(lobby_user, {"op": "enrol", **pin_client(lobby_user, PIN).hello()})
    spliced = asked(lobby_user, {**recorded["claim"], "visit": later["visit"]})
    assert spliced["refused"] == "pin"


@pytest.mark.parametrize("is_changed", [False, True], ids=["forwards", "changes the address"])
def test_join_through_a_relay(room: AttackedClass, is_changed: bool) -> None:
    relay = RecordingProxy(room.port)
    dialled, own = (f"tcp/{HERE}:{port}".encode() for port in (relay.port, room.port))
    assert len(dialled) == len(own)  # Zenoh sends lengths, which the relay does not change
    if is_changed:
        relay.change = lambda chunk: chunk.replace(dialled, own)
    eve = room.computer(f"relayed{relay.port}")
    refused = eve.run("join", f"{HERE}:{relay.port}", "--number", "33", ZBOT_PIN=PIN)
    relay.close()
    assert refused.code == 1
    sentence = "wrong PIN" if is_changed else "this laptop did not dial the class's own machine"
    assert refused.err.startswith(sentence)
    assert dialled in relay.went
    assert len(refused.err.strip().splitlines()) == 1
    assert not eve.has_joined
    assert 33 not in room.listed()
    assert PIN.encode() not in relay.went + relay.came


def test_admission_messages_reveal_neither_pin_nor_names(lobby_user: zenoh.Session) -> None:
    # A listener on the way sees these documents; the laptop's id would make it Carl.
    request = {"machine": "0123456789abcdef", "host": "carl-laptop", "number": 31}
    seen = json.dumps(claimed(lobby_user, PIN, request))
    for word in (PIN, "0123456789abcdef", "carl", "student31"):
        assert word not in seen
        assert word.encode().hex() not in seen


def test_release_another_students_number(room: AttackedClass, ben: zenoh.Session) -> None:
    for proof in ("", "0" * 64, None, "\ud800", {"a": 1}):
        answer = asked(ben, {"op": "release", "number": 17, "proof": proof})
        assert not answer.get("released")
    assert room.listed()[17]["name"] == "Ana"


def test_a_reassigned_number_rejects_the_old_secret(room: AttackedClass) -> None:
    dora = room.student("dora", 40)
    had = dora.credentials
    room.teacher.do("class", "free", "40")
    assert wait_until(lambda: not accepts(room.port, had), 10)
    emil = room.student("emil", 40)
    # The hub is open again, with the new credentials, only when it accepts Emil.
    assert wait_until(lambda: accepts(room.port, emil.credentials), 10)
    assert not accepts(room.port, had)
    emil.do("leave")


def test_a_former_owner_of_a_number_gets_nothing(room: AttackedClass) -> None:
    dora = room.student("dora who left", 43)
    had, user = dora.identity, dora.credentials
    dora.do("leave")
    emil = room.student("emil who came", 43)
    heard = room.teacher_session.declare_subscriber("43/work", zenoh.handlers.FifoChannel(10))
    with open_session(dialling(room.port, user)) as former:  # with another id than the laptop's
        former.put("43/work", b"x")
        room.talk.settle()
        assert heard.try_recv() is None
    heard.undeclare()
    # With the id, the hub is opened again, and then does not know the former owner.
    assert wait_until(lambda: not accepts(room.port, had), 10)
    assert not accepts(room.port, user)
    assert wait_until(lambda: room.listed()[43]["here"], 20)
    emil.do("leave")


def test_guess_the_pin(room: AttackedClass, lobby_user: zenoh.Session) -> None:
    begun_s, wait_s = time.monotonic(), 0.0
    kinds: list[str] = []
    while "wait" not in kinds and len(kinds) < 200:
        guess = f"{len(kinds):06d}"
        answer = claimed(lobby_user, guess, {"machine": "eve"})["answer"]
        kinds.append(answer["refused"])
        wait_s = answer.get("wait_s", 0.0)
    guesses = kinds.count("pin")
    assert kinds == ["pin"] * guesses + ["wait"]
    # Ten are free, and one more comes in two seconds.
    assert 0 < guesses <= 12 + (time.monotonic() - begun_s) / 2
    assert 0 < wait_s <= 2
    late = room.student("frieda", 41)  # who knows it gets in meanwhile, a little later
    late.do("leave")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [("000000", "wrong PIN"), ("", "PIN"), ("4711001", "wrong PIN"), ("x" * 100_000, "wrong PIN")],
)
def test_join_with_a_wrong_pin(room: AttackedClass, words: str, sentence: str) -> None:
    eve = room.computer(f"eve{abs(hash(words))}")
    refused = eve.run("join", f"{HERE}:{room.port}", stdin=f"{words}\n")
    assert refused.code == 1
    assert sentence in refused.err
    assert len(refused.err.strip().splitlines()) == 1


@pytest.mark.parametrize(
    "payload",
    [
        b"",
        b"\xff\xfe",
        b"null",
        b"[]",
        b"1e999",
        b"{" * 100_000,
        b"[" * 100_000 + b"]" * 100_000,
        b'{"op": {"a": []}}',
        b'{"op": "claim", "visit": {}, "claim": [], "proof": 1e400}',
        b'{"op": "enrol", "public": "' + b"f" * 1_000_000 + b'"}',
        b'{"op": "release", "number": 1e999, "proof": "\\ud800"}',
        b'{"op": "release", "number": ' + b"9" * 5000 + b"}",
        b'{"a": "' + b"x" * 10_000_000 + b'"}',
    ],
    ids=lambda payload: f"{payload[:40].decode('latin-1')}{len(payload)}",
)
def test_malformed_admission_requests(lobby_user: zenoh.Session, payload: bytes) -> None:
    list(lobby_user.get(ADMISSION_KEY, payload=payload, timeout=5))
    hello = asked(lobby_user, {"op": "hello"})
    assert hello["class"] == "attacked"


def test_flood_the_admission_service(room: AttackedClass, lobby_user: zenoh.Session) -> None:
    hello = json.dumps({"op": "enrol", **pin_client(lobby_user, "0").hello()})
    waiting = [
        lobby_user.get(ADMISSION_KEY, zenoh.handlers.FifoChannel(1), payload=hello, timeout=20)
        for _ in range(600)
    ]
    room.check_honest_work()
    del waiting
