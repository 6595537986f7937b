from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.text.json_reader import JsonError
from zbot.transport.admin_query import (
    Process,
    RouterFacts,
    all_tokens,
    process_of,
    router_facts,
)

if TYPE_CHECKING:
    from typing_extensions import Self

    from zbot.log.record import Record

FACTS = b'{"host": "desk", "pid": %b, "started": %b, "version": "1", "command": %b}'


def facts(pid: bytes = b"7", started: bytes = b"9", command: bytes = b'"run"') -> bytes:
    return b'{"metadata": {"zbot": %b}}' % (FACTS % (pid, started, command))


@pytest.mark.parametrize(
    "text",
    [b"", b"{", b"[]", b"5", b"[" * 10_000, b'{"a": Infinity}', b'{"a": "\\ud800"}', b"\xff"],
)
def test_an_invalid_answer_is_refused(text: bytes) -> None:
    with pytest.raises(JsonError):
        router_facts(text)
    assert process_of("a1", text) is None


@pytest.mark.parametrize(
    ("text", "sessions"),
    [
        (b"{}", {}),
        (b'{"sessions": 5, "metadata": 5}', {}),
        (b'{"sessions": [5, null, {}, {"peer": 5}, {"peer": []}], "metadata": {"zbot": 5}}', {}),
        (b'{"sessions": [{"peer": "a1", "whatami": []}, {"peer": "a2", "whatami": "x"}]}', {}),
        (b'{"sessions": [{"peer": "**", "whatami": "peer"}]}', {}),
        (b'{"sessions": [5, {"peer": "a1", "whatami": "peer"}]}', {"a1": "peer"}),
    ],
)
def test_invalid_parts_of_an_answer_are_left_out(text: bytes, sessions: dict[str, str]) -> None:
    assert router_facts(text) == RouterFacts(sessions, 0, is_replacement=False)


def test_a_router_tells_whether_it_replaces_a_killed_router() -> None:
    assert router_facts(b'{"metadata": {"zbot": {"replaces": true}}}').is_replacement
    assert not router_facts(b'{"metadata": {"zbot": {"replaces": "yes"}}}').is_replacement


def test_a_router_tells_its_start() -> None:
    assert router_facts(facts(started=b"9")).started_ns == 9
    assert router_facts(facts(started=b"-9")).started_ns == 0
    assert router_facts(facts(started=b"1" * 30)).started_ns == 0
    assert router_facts(facts(started=b'"9"')).started_ns == 0


def test_a_process_is_described() -> None:
    assert process_of("a1", facts()) == Process("a1", "desk", 7, 9, "1", "run")
    described = process_of("a1", facts(command=b'"a\\u001b[2Jb\\nc"'))
    assert described is not None
    assert described.command == "a [2Jb c"


@pytest.mark.parametrize("pid", [b"-1", b"0", b"null", b"1.5", b'"7"', b"99999999999", b"[]"])
def test_a_process_needs_a_valid_number(pid: bytes) -> None:
    assert process_of("a1", facts(pid=pid)) is None
    assert process_of("a1", facts(started=b"-1")) is None


class BusyRouter:
    """Session whose router does not answer the first queries in time."""

    def __init__(self, late: int) -> None:
        self.late = late
        self.limits_s: list[float] = []

    def liveliness(self) -> Self:
        return self

    def get(self, key: str, _queue: object, *, timeout: float) -> list[Any]:
        self.limits_s.append(timeout)
        found = SimpleNamespace(ok=SimpleNamespace(key_expr=f"{key}/token"))
        return [found] if len(self.limits_s) > self.late else [SimpleNamespace(ok=None)]


def test_a_busy_router_is_asked_again_for_tokens(logged: list[Record]) -> None:
    router: Any = BusyRouter(late=1)
    assert all_tokens(router, ["a", "b"]) == ["a/token", "b/token"]
    first, again = router.limits_s[0], router.limits_s[-1]
    assert router.limits_s == [first, first, again, again]
    assert again > first
    assert not logged


def test_a_router_that_does_not_answer_is_told(logged: list[Record]) -> None:
    router: Any = BusyRouter(late=4)
    assert all_tokens(router, ["a", "b"]) == []
    (line,) = logged
    assert line.message == "the router did not answer within 10 s: some nodes may be missing"
