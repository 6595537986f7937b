"""Tests of the order in which a context's session is opened and closed."""

from __future__ import annotations

from typing import Any, Literal

import pytest

from zbot.context import domain_session
from zbot.context.domain_session import DomainSession
from zbot.wire.dialect import NATIVE


class Meeting:
    """Meeting point without a network."""

    is_client = True
    shares_memory = False
    dialect = None

    def __init__(self, happened: list[str], *, has_router: bool) -> None:
        self._happened = happened
        self._has_router = has_router

    def start_router(self) -> None:
        self._happened.append("router")

    def open_node_session(self) -> Session:
        self._happened.append("node session")
        return Session(self._happened)

    def open_tool_session(self, *, wait: bool) -> Session | None:
        self._happened.append(f"tool session {wait}")
        return Session(self._happened) if self._has_router else None

    def close(self) -> None:
        self._happened.append("meeting closed")


class Session:
    def __init__(self, happened: list[str]) -> None:
        self._happened = happened
        self._is_closed = False

    def is_closed(self) -> bool:
        return self._is_closed

    def close(self) -> None:
        self._is_closed = True
        self._happened.append("session closed")


class Peering:
    def __init__(self, session: Session, meeting: Meeting, receiver: Any) -> None:
        del session, receiver
        self._happened = meeting._happened

    def start(self) -> None:
        self._happened.append("peering")

    def link(self, is_over: Any) -> None:
        assert not is_over()
        self._happened.append("linked")

    def wait_for_answers(self, timeout_s: float) -> None:
        del timeout_s
        self._happened.append("answers")

    def join(self) -> None:
        self._happened.append("peering ended")


class Registration:
    def __init__(self, domain: int, *, is_tool: bool) -> None:
        del domain, is_tool

    def close(self) -> None:
        """Forget the program."""


@pytest.fixture
def happened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    monkeypatch.setattr(domain_session, "Peering", Peering)
    monkeypatch.setattr(domain_session, "Registration", Registration)
    return []


def session_of(
    happened: list[str], mode: Literal["peer", "client"] = "peer", *, has_router: bool = True
) -> DomainSession:
    made = DomainSession(mode, None, lambda _: None, lambda: happened.append("open"))
    made.domain = 7
    meeting: Any = Meeting(happened, has_router=has_router)
    made._new_meeting = lambda: meeting  # type: ignore[method-assign]
    return made


def test_a_node_starts_the_router_and_links_to_the_other_nodes(happened: list[str]) -> None:
    session = session_of(happened)
    assert session.is_closed
    session.open(lambda: False)
    # `close` finds everything that is open, also if a signal comes before the peering starts.
    assert happened == ["router", "node session", "open", "peering", "linked"]
    assert not session.is_closed
    assert not session.asks_router
    assert session.dialect is NATIVE


@pytest.mark.parametrize("wait", [False, True])
def test_a_tool_is_a_client_of_the_router(happened: list[str], *, wait: bool) -> None:
    session = session_of(happened, "client")
    session.open_tool(wait=wait)
    assert happened == [f"tool session {wait}", "open", *(["peering"] if wait else [])]
    assert session.asks_router


def test_a_tool_that_does_not_wait_opens_nothing_without_a_router(happened: list[str]) -> None:
    session = session_of(happened, "client", has_router=False)
    session.open_tool(wait=False)
    assert session.is_closed
    assert happened == ["tool session False"]


def test_a_tool_that_waits_opens_a_nodes_session_without_a_router(happened: list[str]) -> None:
    session = session_of(happened, "client", has_router=False)
    session.open_tool(wait=True)
    assert happened == ["tool session True", "node session", "open", "peering"]
    assert not session.is_closed


def test_the_session_is_closed_before_the_wait_for_its_threads(happened: list[str]) -> None:
    session = session_of(happened)
    session.open(lambda: False)
    happened.clear()
    session.close(lambda: happened.append("threads ended"))
    ended = ["session closed", "threads ended", "peering ended", "meeting closed"]
    assert happened == ended
    assert session.is_closed


def test_only_a_session_that_asks_no_router_waits_for_peers(happened: list[str]) -> None:
    modes: tuple[Literal["peer", "client"], ...] = ("peer", "client")
    for mode in modes:
        session = session_of(happened, mode)
        session.wait_for_peers()
        session.open(lambda: False)
        happened.clear()
        session.wait_for_peers()
        session.wait_for_discovery()
        assert happened == (["answers"] * 2 if mode == "peer" else [])


def test_a_forked_child_has_no_session(happened: list[str]) -> None:
    session = session_of(happened)
    session.open(lambda: False)
    session._registration = None
    happened.clear()
    session.leave_to_parent()
    assert session.is_closed
    session.close(lambda: None)
    assert happened == []
