"""Attendance of a class: the laptops that the teacher's hub sees, and the facts they report."""

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
_MAX_TIME_NS = 1 << 63  # limit for `time_ns`: a number in JSON may have thousands of digits
_NODE_TOKENS = "@zbot/*/*/*/*/NN/**"


@dataclass
class ConnectedLaptop:
    """Facts about a student's laptop."""

    is_here: bool = False
    since_ns: int = 0  #: time of the last connection or disconnection (0 if never connected)
    version: str = ""
    system: str = ""
    last_error: dict[str, Any] | None = field(default=None)
    clock_offset_s: float | None = None  #: its clock minus the teacher's


class Attendance:
    """Records which laptops are connected. All methods may be called from any thread."""

    def __init__(self) -> None:
        self._laptops: dict[int, ConnectedLaptop] = {}
        self._lock = threading.Lock()
        self._serving: HubProcess | None = None
        self._watched: dict[int, Any] = {}
        self._arrivals: queue.SimpleQueue[tuple[int, bool] | None] = queue.SimpleQueue()

    def attach(self, serving: HubProcess, numbers: Iterable[int]) -> None:
        """Watch the laptops of these numbers through a hub that was opened."""
        with self._lock:
            self._serving = serving
            self._watched.clear()
        for number in numbers:
            self.watch(number)

    def watch(self, number: int) -> None:
        """Watch a student's laptop. Do nothing if it is watched already."""
        serving = self._serving
        with self._lock:
            if serving is None or number in self._watched:
                return
            # `history` means that tokens which exist already are reported too.
            self._watched[number] = serving.session.liveliness().declare_subscriber(
                here_key(number), self._token_callback(number), history=True
            )

    def _token_callback(self, number: int) -> Any:
        @called_by_zenoh
        def on_token(sample: zenoh.Sample) -> None:
            self._note(number, sample.kind == zenoh.SampleKind.PUT)

        return on_token

    def _note(self, number: int, is_here: bool) -> None:
        with self._lock:
            laptop = self._laptops.setdefault(number, ConnectedLaptop())
            if laptop.is_here != is_here:
                laptop.is_here, laptop.since_ns = is_here, time.time_ns()

    def forget(self, number: int) -> None:
        """Forget a laptop whose number was released."""
        with self._lock:
            self._laptops.pop(number, None)
            watched = self._watched.pop(number, None)
        if watched is not None:
            watched.undeclare()

    def laptop(self, number: int) -> ConnectedLaptop:
        """Return the facts about a laptop."""
        with self._lock:
            return self._laptops.setdefault(number, ConnectedLaptop())

    def present(self) -> list[int]:
        """Return the numbers of the connected laptops."""
        with self._lock:
            return [number for number, laptop in self._laptops.items() if laptop.is_here]

    def refresh(self) -> None:
        """Query the facts of all connected laptops. Wait for the slowest laptop, at most 1 s."""
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
        laptop = self.laptop(number)
        laptop.version = clean_name(str(facts.get("version", "")))
        laptop.system = clean_name(str(facts.get("system", "")))
        their_ns = facts.get("time_ns")
        if isinstance(their_ns, int) and 0 <= their_ns < _MAX_TIME_NS:
            # As in NTP: assume that the laptop read its clock half-way between query and reply.
            laptop.clock_offset_s = (their_ns - (asked_ns + came_ns) // 2) / 1e9
        error = facts.get("last_error")
        if isinstance(error, dict):
            laptop.last_error = {
                "node": clean_name(str(error.get("node"))),
                "text": clean_name(str(error.get("text"))),
            }

    def nodes(self) -> dict[int, list[str]]:
        """Return the full names of all nodes by domain. Hidden nodes are left out."""
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
        return None  # a student's program may declare any token in its domain
    return token if isinstance(token, NodeToken) else None
