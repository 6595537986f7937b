"""Check whether the domain of each student of a class meets the teacher's expectations."""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.graph.snapshot import Snapshot
from zbot.threads.foreign_call import called_by_zenoh
from zbot.transport import admin_query
from zbot.wire.errors import TokenError
from zbot.wire.keys import topic_key
from zbot.wire.tokens import parse_token, token_selector

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    import zenoh

    from zbot.classroom.teacher.expectation import Expectation, Observed
    from zbot.graph.snapshot import Token

_TOKENS_TIMEOUT_S = 2.0
_SHORTEST_S, _LONGEST_S = 2.5, 20.0
_PERIODS = 3.5  # at least three messages of the slowest topic


@dataclass(frozen=True)
class Verdict:
    """Result of the check of one student."""

    number: int
    name: str
    problems: tuple[str, ...]  #: empty if the student has passed

    @property
    def passes(self) -> bool:
        """Whether the student meets all expectations."""
        return not self.problems


def check(
    session: zenoh.Session,
    students: Sequence[dict[str, Any]],
    expectations: Sequence[Expectation],
) -> list[Verdict]:
    """Return a verdict for each student.

    If an expectation has a rate, the check takes 2.5 to 20 s, because it counts messages.

    Args:
        session: A client of the teacher's hub.
        students: Rows of the class's list. Each row has `number`, `name` and `here`.
        expectations: The expectations for every student.
    """
    here = [student["number"] for student in students if student["here"]]
    timed = [expected for expected in expectations if expected.has_rate]
    rates = _rates(session, here, timed)
    graphs = snapshots(session, here)
    verdicts = []
    for student in students:
        number = student["number"]
        problems = ["is not here"]
        if number in graphs:
            graph: Observed = graphs[number]  # pyright: ignore[reportAssignmentType] - see Observed
            problems = [expected.problem(graph, rates[number]) for expected in expectations]
        verdicts.append(Verdict(number, student["name"], tuple(filter(None, problems))))
    return verdicts


def snapshots(session: zenoh.Session, numbers: Iterable[int]) -> dict[int, Snapshot]:
    """Return the graphs of some students' domains, as a client of the teacher's hub sees them."""
    asked = {
        number: admin_query.tokens(session, token_selector(number), _TOKENS_TIMEOUT_S)
        for number in numbers
    }
    return {number: Snapshot(tuple(_tokens(keys))) for number, keys in asked.items()}


def _tokens(keys: Iterable[str]) -> list[Token]:
    found: list[Token] = []
    for key in keys:
        try:
            found.append(parse_token(key))
        except TokenError:
            continue  # a student may declare any token in its own domain
    return found


class _Counter:
    """Number and arrival times of the messages of one topic."""

    def __init__(self) -> None:
        self._first_s = self._last_s = 0.0
        self._count = 0
        self._lock = threading.Lock()

    @called_by_zenoh
    def add(self, _sample: zenoh.Sample) -> None:
        now = time.monotonic()
        with self._lock:
            self._first_s = self._first_s or now
            self._last_s = now
            self._count += 1

    def rate_hz(self, window_s: float) -> float:
        """Return the mean rate. With 0 or 1 message, return this number divided by `window_s`."""
        with self._lock:
            if self._count < 2:
                return self._count / window_s
            return (self._count - 1) / max(self._last_s - self._first_s, 1e-9)


def _rates(
    session: zenoh.Session, numbers: Sequence[int], timed: Sequence[Expectation]
) -> dict[int, dict[str, float]]:
    counters = {number: {expected.name: _Counter() for expected in timed} for number in numbers}
    if not timed:
        return {number: {} for number in numbers}
    slowest_hz = min((expected.rate_hz for expected in timed if expected.rate_hz > 0), default=1.0)
    window_s = min(max(_SHORTEST_S, _PERIODS / slowest_hz), _LONGEST_S)
    subscribers = [
        session.declare_subscriber(topic_key(number, name), counter.add)
        for number, topics in counters.items()
        for name, counter in topics.items()
    ]
    threading.Event().wait(window_s)
    for subscriber in subscribers:
        subscriber.undeclare()
    return {
        number: {name: counter.rate_hz(window_s) for name, counter in topics.items()}
        for number, topics in counters.items()
    }
