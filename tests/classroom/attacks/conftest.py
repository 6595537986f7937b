"""Class with a PIN, and the sessions of its attackers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from tests.classroom.attacked import AttackedClass, pin_client

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zenoh


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory) -> Iterator[AttackedClass]:
    """Return a class that was opened with `zbot class start --pin`."""
    made = AttackedClass(tmp_path_factory.mktemp("class"))
    yield made
    made.close()


@pytest.fixture
def room(opened: AttackedClass) -> Iterator[AttackedClass]:
    """Return the class; after the attack, Ana and the teacher can still work."""
    yield opened
    opened.check_honest_work()


@pytest.fixture(params=["directly", "through his own hub"])
def ben(request: pytest.FixtureRequest, room: AttackedClass) -> Iterator[zenoh.Session]:
    with room.as_ben(directly=request.param == "directly") as session:
        yield session


@pytest.fixture
def guest(room: AttackedClass) -> Iterator[zenoh.Session]:
    with room.as_guest_of_ben() as session:
        yield session


@pytest.fixture
def lobby_user(room: AttackedClass) -> Iterator[zenoh.Session]:
    with room.as_lobby_user() as session:
        yield session


@pytest.fixture
def raw_client(room: AttackedClass) -> Iterator[zenoh.Session]:
    with room.as_raw_client() as session:
        yield session


asked = AttackedClass.ask_admission


def claimed(session: zenoh.Session, pin: str, request: dict[str, Any]) -> dict[str, Any]:
    """Claim a number with a PIN; return the claim and its answer."""
    client = pin_client(session, pin)
    challenge = asked(session, {"op": "enrol", **client.hello()})
    if "refused" in challenge:
        return {"answer": challenge}
    claim = {"op": "claim", **client.claim(challenge, request)}
    return {"claim": claim, "answer": asked(session, claim)}


def is_plain(shown: str) -> bool:
    """Return whether a terminal does nothing but print it."""
    return all(char.isprintable() or char == "\n" for char in shown)
