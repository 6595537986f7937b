"""Laptops of a class: the teacher's hub watches them, and asks for the facts that they report."""

from __future__ import annotations

import contextlib
import queue
import threading
import time
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.hub.queries import document_of
from zbot.classroom.join_request import clean_name
from zbot.classroom.keys import facts_key, here_key
from zbot.classroom.teacher.running_nodes import RunningNodes
from zbot.threads.deadline import Deadline
from zbot.threads.foreign_call import called_by_zenoh

if TYPE_CHECKING:
    from zbot.classroom.hub.process import HubProcess
    from zbot.classroom.teacher.student_list import StudentList

_FACTS_TIMEOUT_S = 2.0  # on bad Wi-Fi, TCP has to repeat a packet
_MAX_TIME_NS = 1 << 63  # limit for `time_ns`: a number in JSON may have thousands of digits


class Laptops:
    """Laptops of the students of a class. All methods may be called from any thread.

    Args:
        students: The list in which the hub notes what it sees and hears of the laptops.
    """

    def __init__(self, students: StudentList) -> None:
        self.nodes = RunningNodes()  #: the nodes on the laptops
        self._students = students
        self._lock = threading.Lock()
        self._serving: HubProcess | None = None
        self._watched: dict[int, Any] = {}

    def attach(self, serving: HubProcess) -> None:
        """Watch the laptops of all students through a hub that was opened."""
        self._serving = serving
        serving.call_on_close(self._forget_all)
        # A laptop may have left while the hub was closed. Zenoh does not report this.
        self._students.expect_return()
        self.nodes.watch(serving)
        for student in self._students.students():
            self.watch(student.number)

    def watch(self, number: int) -> None:
        """Watch a student's laptop. Do nothing if it is watched already."""
        with self._lock:
            serving = self._serving
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
            self._students.note_seen(number, is_here=sample.kind == zenoh.SampleKind.PUT)

        return on_token

    def forget(self, number: int) -> None:
        """Stop watching a laptop whose number was freed."""
        with self._lock:
            watched = self._watched.pop(number, None)
        if watched is not None:
            with contextlib.suppress(zenoh.ZError):  # the hub is being reopened
                watched.undeclare()

    def _forget_all(self) -> None:
        with self._lock:
            self._serving = None
            self._watched.clear()

    def refresh(self) -> None:
        """Query the facts of all connected laptops. Wait for the slowest laptop, at most 2 s."""
        serving = self._serving
        if serving is None:
            return
        answers: queue.SimpleQueue[tuple[int, dict[str, Any], int]] = queue.SimpleQueue()
        here = self._students.here()
        asked = {number: self._ask(serving.session, number, answers) for number in here}
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
        laptop = self._students.laptop(number)
        laptop.version = clean_name(str(facts.get("version", "")))
        laptop.system = clean_name(str(facts.get("system", "")))
        their_ns = facts.get("time_ns")
        if isinstance(their_ns, int) and 0 <= their_ns < _MAX_TIME_NS:
            # As in NTP: assume that the laptop read its clock half-way between query and reply. An
            # offset that may come from the network alone is not told.
            offset_ns = their_ns - (asked_ns + came_ns) // 2
            is_sure = abs(offset_ns) > (came_ns - asked_ns) // 2
            laptop.clock_offset_s = offset_ns / 1e9 if is_sure else 0.0
        error = facts.get("last_error")
        if isinstance(error, dict):
            laptop.last_error = {
                "node": clean_name(str(error.get("node"))),
                "text": clean_name(str(error.get("text"))),
            }
