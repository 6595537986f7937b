"""Attendance of a class: the laptops that the teacher's hub sees, and the facts they report."""

from __future__ import annotations

import contextlib
import queue
import threading
import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.hub.queries import document_of
from zbot.classroom.keys import facts_key, here_key
from zbot.classroom.teacher.running_nodes import RunningNodes
from zbot.classroom.teacher.student_list import clean_name
from zbot.threads.deadline import Deadline
from zbot.threads.foreign_call import called_by_zenoh

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.classroom.hub.process import HubProcess

_FACTS_TIMEOUT_S = 1.0
_RETURN_S = 5.0  # laptops reconnect within a second after the hub was reopened
_MAX_TIME_NS = 1 << 63  # limit for `time_ns`: a number in JSON may have thousands of digits


@dataclass
class ConnectedLaptop:
    """Facts about a student's laptop."""

    is_here: bool = False
    since_ns: int = 0  #: time of the last connection or disconnection (0 if never connected)
    version: str = ""
    system: str = ""
    last_error: dict[str, Any] | None = field(default=None)
    clock_offset_s: float | None = None  #: the laptop's clock minus the teacher's


class Attendance:
    """Records which laptops are connected. All methods may be called from any thread."""

    def __init__(self) -> None:
        self.nodes = RunningNodes()  #: the nodes on the laptops
        self._laptops: dict[int, ConnectedLaptop] = {}
        self._lock = threading.Lock()
        self._serving: HubProcess | None = None
        self._watched: dict[int, Any] = {}
        self._unconfirmed: set[int] = set()  #: laptops that were here before the hub was reopened
        self._confirm_until_s = 0.0
        self._arrivals: queue.SimpleQueue[tuple[int, bool] | None] = queue.SimpleQueue()

    def attach(self, serving: HubProcess, numbers: Iterable[int]) -> None:
        """Watch the laptops of these numbers through a hub that was opened."""
        with self._lock:
            self._serving = serving
            self._watched.clear()
            # A laptop may have left while the hub was closed. Zenoh does not report this.
            self._unconfirmed = {n for n, one in self._laptops.items() if one.is_here}
            self._confirm_until_s = time.monotonic() + _RETURN_S
        self.nodes.watch(serving)
        for number in numbers:
            self.watch(number)

    def watch(self, number: int) -> None:
        """Watch a student's laptop. Do nothing if it is watched already."""
        serving = self._serving
        with self._lock:
            if serving is None or number in self._watched:
                return
            # If the hub is being reopened, `attach` watches the laptop afterwards.
            with contextlib.suppress(zenoh.ZError):
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
            self._unconfirmed.discard(number)
            laptop = self._laptops.setdefault(number, ConnectedLaptop())
            if laptop.is_here != is_here:
                laptop.is_here, laptop.since_ns = is_here, time.time_ns()

    def forget(self, number: int) -> None:
        """Forget a laptop whose number was released."""
        with self._lock:
            self._laptops.pop(number, None)
            watched = self._watched.pop(number, None)
        if watched is not None:
            with contextlib.suppress(zenoh.ZError):  # the hub is being reopened
                watched.undeclare()

    def laptop(self, number: int) -> ConnectedLaptop:
        """Return the facts about a laptop."""
        with self._lock:
            self._drop_unconfirmed()
            return self._laptops.setdefault(number, ConnectedLaptop())

    def _drop_unconfirmed(self) -> None:
        """Note that missing laptops are gone, if 5 s have passed since the hub was reopened."""
        if time.monotonic() > self._confirm_until_s:
            for number in self._unconfirmed & self._laptops.keys():
                laptop = self._laptops[number]
                laptop.is_here, laptop.since_ns = False, time.time_ns()
            self._unconfirmed = set()

    def present(self) -> list[int]:
        """Return the numbers of the connected laptops."""
        with self._lock:
            self._drop_unconfirmed()
            return [number for number, laptop in self._laptops.items() if laptop.is_here]

    def refresh(self) -> None:
        """Query the facts of all connected laptops. Wait for the slowest laptop, at most 1 s."""
        serving = self._serving
        if serving is None:
            return
        answers: queue.SimpleQueue[tuple[int, dict[str, Any], int]] = queue.SimpleQueue()
        asked = {number: self._ask(serving.session, number, answers) for number in self.present()}
        deadline = Deadline(_FACTS_TIMEOUT_S)
        for _ in asked:
            try:
                number, facts, came_ns = answers.get(timeout=deadline.left_s)
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
