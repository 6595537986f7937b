"""Which laptops are there, as the teacher's hub sees them, and what they say of themselves."""

from __future__ import annotations

import queue
import threading
import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.hub_queries import document_of
from zbot.classroom.keys import facts_key, here_key
from zbot.classroom.register import clean_name
from zbot.names import fully_qualified, is_hidden
from zbot.transport import admin_query
from zbot.transport.foreign_call import called_by_zenoh
from zbot.wire.tokens import NodeToken, parse_token

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.classroom.hub_process import HubProcess

_FACTS_TIMEOUT_S = 1.0
_LATEST_NS = 1 << 63  # the latest that clocks show; a number in JSON may have thousands of digits
_NODE_TOKENS = "@zbot/*/*/*/*/NN/**"


@dataclass
class ConnectedLaptop:
    """What is known of a student's laptop."""

    is_here: bool = False
    since_ns: int = 0  #: when it came or went, since the epoch; 0 if it never came
    version: str = ""
    system: str = ""
    last_error: dict[str, Any] | None = field(default=None)
    clock_offset_s: float | None = None  #: how far its clock is ahead of the teacher's


class Attendance:
    """Follows who comes and goes.

    All methods may be called from any thread.
    """

    def __init__(self) -> None:
        self._seats: dict[int, ConnectedLaptop] = {}
        self._lock = threading.Lock()
        self._serving: HubProcess | None = None
        self._watched: dict[int, Any] = {}
        self._arrivals: queue.SimpleQueue[tuple[int, bool] | None] = queue.SimpleQueue()

    def equip(self, serving: HubProcess, numbers: Iterable[int]) -> None:
        """Begin to watch, with a hub that was opened."""
        with self._lock:
            self._serving = serving
            self._watched.clear()
        for number in numbers:
            self.watch(number)

    def watch(self, number: int) -> None:
        """Watch for a student's laptop."""
        serving = self._serving
        with self._lock:
            if serving is None or number in self._watched:
                return
            # A token's subscriber is told of one that is there already.
            self._watched[number] = serving.session.liveliness().declare_subscriber(
                here_key(number), self._teller(number), history=True
            )

    def _teller(self, number: int) -> Any:
        @called_by_zenoh
        def tell(sample: zenoh.Sample) -> None:
            self._note(number, sample.kind == zenoh.SampleKind.PUT)

        return tell

    def _note(self, number: int, is_here: bool) -> None:
        with self._lock:
            seat = self._seats.setdefault(number, ConnectedLaptop())
            if seat.is_here != is_here:
                seat.is_here, seat.since_ns = is_here, time.time_ns()

    def forget(self, number: int) -> None:
        """Forget a laptop whose number was given back."""
        with self._lock:
            self._seats.pop(number, None)
            watched = self._watched.pop(number, None)
        if watched is not None:
            watched.undeclare()

    def seat(self, number: int) -> ConnectedLaptop:
        """Return what is known of a laptop."""
        with self._lock:
            return self._seats.setdefault(number, ConnectedLaptop())

    def present(self) -> list[int]:
        """Return the numbers of the laptops that are there."""
        with self._lock:
            return [number for number, seat in self._seats.items() if seat.is_here]

    def refresh(self) -> None:
        """Ask everybody who is there for facts; takes as long as the slowest, 1 s at most."""
        serving = self._serving
        if serving is None:
            return
        answers: queue.SimpleQueue[tuple[int, dict[str, Any], int]] = queue.SimpleQueue()
        asked = {number: self._ask(serving.session, number, answers) for number in self.present()}
        deadline = time.monotonic() + _FACTS_TIMEOUT_S
        for _ in asked:
            try:
                number, facts, came_ns = answers.get(timeout=max(0, deadline - time.monotonic()))
            except queue.Empty:
                return
            self._learn(number, facts, asked[number], came_ns)

    @staticmethod
    def _ask(
        session: zenoh.Session,
        number: int,
        answers: queue.SimpleQueue[tuple[int, dict[str, Any], int]],
    ) -> int:
        @called_by_zenoh
        def note(reply: zenoh.Reply) -> None:
            if reply.ok is not None:
                answers.put((number, document_of(reply.ok.payload), time.time_ns()))

        asked_ns = time.time_ns()
        session.get(facts_key(number), note, timeout=_FACTS_TIMEOUT_S)
        return asked_ns

    def _learn(self, number: int, facts: dict[str, Any], asked_ns: int, came_ns: int) -> None:
        seat = self.seat(number)
        seat.version = clean_name(str(facts.get("version", "")))
        seat.system = clean_name(str(facts.get("system", "")))
        their_ns = facts.get("time_ns")
        if isinstance(their_ns, int) and 0 <= their_ns < _LATEST_NS:
            # The answer was given half-way between question and arrival, as NTP assumes.
            seat.clock_offset_s = (their_ns - (asked_ns + came_ns) // 2) / 1e9
        error = facts.get("last_error")
        if isinstance(error, dict):
            seat.last_error = {
                "node": clean_name(str(error.get("node"))),
                "text": clean_name(str(error.get("text"))),
            }

    def nodes(self) -> dict[int, list[str]]:
        """Return the full names of everybody's nodes, by domain, without hidden ones."""
        serving = self._serving
        found: dict[int, list[str]] = {}
        if serving is None:
            return found
        for key in admin_query.tokens(serving.session, _NODE_TOKENS, _FACTS_TIMEOUT_S):
            token = _node_of(key)
            if token is not None:
                name = fully_qualified(token.namespace, token.node)
                if not is_hidden(name):
                    found.setdefault(token.domain, []).append(name)
        return found


def _node_of(key: str) -> NodeToken | None:
    try:
        token = parse_token(key)
    except ValueError:
        return None  # anybody may declare tokens in his own domain
    return token if isinstance(token, NodeToken) else None
