"""Filter between a class and its robot: only the driver's messages may pass."""

from __future__ import annotations

import threading
from functools import partial
from typing import TYPE_CHECKING

import zenoh

from zbot.classroom.hub.queries import ask, document_of
from zbot.classroom.keys import COMMAND_KEY, ROBOTS_KEY
from zbot.classroom.teacher.robots import driver_in
from zbot.graph.token_changes import TokenChanges
from zbot.threads.deadline import Deadline
from zbot.transport import membership
from zbot.wire.tokens import token_selector

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context

_ASK_S = 0.5
_ANSWER_S = 1.0
# If the class does not answer for this time, nobody drives. The time is so long because the hub is
# closed for a moment when its rules change.
_LOST_S = 5.0


class DriverFilter:
    """Filter that knows the driver of a robot, and lets only the driver's messages pass.

    A message contains the id of its publisher. The message may pass if the publisher's session has
    tokens in the driver's domain, because only the driver's laptop may declare tokens there. The
    filter is not safe in a class whose shared space is open: in such a class, a student can write
    the id of another publisher into a message.

    Args:
        context: The bridge's context, on the teacher's machine.
        robot: The robot's name.
        stop: Called when a driver stops driving, in a thread of Zenoh or of the filter.
        end: Called when the class is closed.
    """

    def __init__(
        self,
        context: Context,
        robot: str,
        stop: Callable[[], None],
        end: Callable[[], None],
    ) -> None:
        self._context, self._robot = context, robot
        self._stop, self._end = stop, end
        self.driver: int | None = None
        self._sessions: set[str] = set()  # Zenoh ids of the driver's programs
        self._tokens: set[str] = set()
        self._watch: TokenChanges | None = None
        self._lock = threading.RLock()
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._poll, name="zbot robot driver", daemon=True)

    def start(self) -> None:
        """Begin to ask the class who drives."""
        receiver = self._context.receiver(self._on_drivers, may_wait=True)
        self._drivers = self._context.session.declare_subscriber(ROBOTS_KEY, receiver)
        self._thread.start()

    def admits(self, name: str, gid: bytes) -> bool:
        """Return whether a message or a request of this publisher or client may pass."""
        del name
        if self._is_of_driver(gid):
            return True
        # A program's first message may be here before its tokens were noted.
        self._context.graph.catch_up()
        if (watch := self._watch) is not None:
            watch.catch_up()
        return self._is_of_driver(gid)

    def _is_of_driver(self, gid: bytes) -> bool:
        sender = self._context.graph.find(gid)
        return sender is not None and sender.zid in self._sessions

    def _poll(self) -> None:
        silence = Deadline(_LOST_S)
        while not self._is_over.is_set():
            joined = membership.load()
            if joined is None or joined.role != "teacher":
                self._end()
                return
            question = {"op": "robot", "robot": self._robot}
            try:
                answers = ask(self._context.session, COMMAND_KEY, question, timeout_s=_ANSWER_S)
            except zenoh.ZError:
                if self._context.is_closed:
                    return  # the bridge ends
                answers = []  # after `_LOST_S`, nobody drives
            if answers and "error" not in answers[0]:
                silence = Deadline(_LOST_S)
                number = answers[0].get("driver")
                self._set(number if isinstance(number, int) else None)
            elif silence.is_over:
                self._set(None)
            self._is_over.wait(_ASK_S)

    def _on_drivers(self, sample: zenoh.Sample) -> None:
        self._set(driver_in(document_of(sample.payload), self._robot))

    def _set(self, number: int | None) -> None:
        with self._lock:
            if number == self.driver:
                return
            self.driver = number
            watch, self._watch = self._watch, None
            had_sessions = bool(self._sessions)
            self._sessions, self._tokens = set(), set()
            if number is not None:
                self._watch = TokenChanges(
                    self._context.session,
                    partial(self._note, number),
                    self._context.receiver,
                    self._context.start_thread,
                )
                self._watch.follow(token_selector(number))
        # This is outside of the lock: `close` may wait for a callback that waits for the lock.
        if watch is not None and not self._context.is_closed:
            watch.close()
        if had_sessions:
            self._stop()

    def _note(self, number: int, sample: zenoh.Sample) -> None:
        """Note a token of the driver's domain."""
        key = str(sample.key_expr)
        with self._lock:
            if number != self.driver:
                return
            before = set(self._sessions)
            if sample.kind == zenoh.SampleKind.PUT:
                self._tokens.add(key)
            else:
                self._tokens.discard(key)
            self._sessions = {token.split("/")[2] for token in self._tokens}
            has_left = bool(before - self._sessions)
        if has_left:
            self._stop()  # e.g. the driver's program has ended while the robot moved

    def close(self) -> None:
        """Stop asking the class. From now on, nobody drives."""
        self._is_over.set()
        if self._thread.is_alive():
            self._thread.join()
        self._set(None)
