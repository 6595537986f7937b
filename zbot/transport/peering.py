"""Peering of a session: keeps the meeting port open and the session linked to all peers.

The meeting router introduces the peers of a domain to each other once, and then Zenoh dials once.
The two peers may be too busy to answer in time, for example on a laptop that starts twenty
programs. Without this module, they would never be linked then.
"""

from __future__ import annotations

import contextlib
import queue
import threading
import time
from collections import Counter
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.transport import admin_query
from zbot.transport.errors import SessionError
from zbot.transport.foreign_call import without_interruption

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.transport.session import MeetingPoint

# Zenoh changes its lists of links a short time after it reports a new or lost link.
_LINK_PAUSE_S = 0.005
_LISTING_TIMEOUT_S = 0.1
_ANSWER_TIMEOUT_S = 1.0  # a router answers within 3 ms, on a busy machine within half a second
_LONGEST_PAUSE_S = 1.0
# A session whose links have not changed for this time looks for peers that it has no link to.
_CHECK_DELAY_S = 1.0
# A session introduces each of these peers at most this number of times. The pause doubles after
# each introduction. Dead peers are introduced too, because the router lists them for 10 s.
_MAX_INTRODUCTIONS = 5
_INTRODUCTION_TIMEOUT_S = 2.0  # an introduction usually takes 50 ms
_INTRODUCTION_PAUSE_S = 0.02
_JOIN_TIMEOUT_S = 2.0  # the thread ends within a millisecond after its session


class Peering:
    """Keeps the meeting port open, and a session linked to all peers, until the session is closed.

    One thread waits, without polling, for links to appear and disappear. When the link to the
    router disappears, the thread tries to open a router on the port, and exactly one of the
    domain's processes succeeds. When the links have not changed for a time, the thread asks the
    router for its peers. If a link to any of these peers is missing, the thread opens an introducer
    session, which introduces the peers to each other again.

    Args:
        session: The session.
        meeting: The meeting point of the session's domain.
        receiver: Turns a function into a callback that Zenoh calls until the session is closed.
    """

    def __init__(
        self,
        session: zenoh.Session,
        meeting: MeetingPoint,
        receiver: Callable[[Callable[[Any], None]], Any],
    ) -> None:
        self._session = session
        self._meeting = meeting
        self._changed = threading.Condition()
        self._events: queue.SimpleQueue[Any] = queue.SimpleQueue()  # `None` ends the thread
        self._introductions: Counter[str] = Counter()  # how often each session was introduced
        self._closing = threading.Event()
        listen = session.info.declare_transport_events_listener
        without_interruption(listen, receiver(self._on_event), history=True)
        # The delays differ, so that not all sessions open an introducer at the same time.
        self._extra_delay = int(self._own()[:4], 16) / 0x10000
        self._thread = threading.Thread(target=self._run, name="zbot meeting", daemon=True)

    def start(self) -> None:
        """Start the thread."""
        without_interruption(self._thread.start)

    def _on_event(self, event: Any) -> None:
        self._events.put(event)
        with self._changed:
            self._changed.notify_all()

    def _run(self) -> None:
        timeout_s: float | None = _CHECK_DELAY_S
        while True:
            try:
                event = self._events.get(timeout=timeout_s)
            except queue.Empty:
                pause_s = self._check()
            else:
                if event is None:
                    return
                if event.kind == zenoh.SampleKind.DELETE:
                    self._replace_router(str(event.transport.zid))
                pause_s = _CHECK_DELAY_S
            timeout_s = None if pause_s is None else pause_s * (1 + self._extra_delay)

    def _replace_router(self, gone: str) -> None:
        self._wait(lambda: gone not in self._routers(), _LISTING_TIMEOUT_S)
        # A killed process loses its links a short time before its port. And after another process
        # has taken the port, this session needs a short time to link to that process.
        pause_s = _LINK_PAUSE_S
        while not (self._session.is_closed() or self._routers()):
            self._meeting.start_router()
            if self._closing.wait(pause_s):
                return
            pause_s = min(2 * pause_s, _LONGEST_PAUSE_S)

    def _own(self) -> str:
        return str(self._session.info.zid())

    def _routers(self) -> set[str]:
        return {str(zid) for zid in self._session.info.routers_zid()}

    def _peers(self) -> set[str]:
        return {str(zid) for zid in self._session.info.peers_zid()}

    def wait_for_router(self, timeout_s: float) -> bool:
        """Wait until the session is linked to a router. Return `False` if the time is over."""
        return self._wait(lambda: bool(self._routers()), timeout_s)

    def wait_for_answers(self, timeout_s: float) -> bool:
        """Send a query to all sessions that the router lists, and wait for their answers.

        An answer arrives after all declarations that its sender made before. So after the last
        answer, a published message reaches the subscribers that these sessions had. The wait takes
        5 to 30 ms after a session was opened.
        """
        deadline = time.monotonic() + timeout_s
        if not self.wait_for_router(timeout_s):
            return False
        answered = {self._own()}
        missing = self._at_router(deadline) - answered
        while missing:
            left = deadline - time.monotonic()
            if left <= 0:
                return False
            answered |= {
                key.split("/")[1] for key, _ in admin_query.answers(self._session, "@/*/*", left)
            }
            if missing <= answered:
                break
            with self._changed:
                self._changed.wait(_LINK_PAUSE_S)
            missing = self._at_router(deadline) - answered  # sessions may have ended
        return True

    def _at_router(self, deadline: float) -> set[str]:
        """Return the ids of the sessions that the meeting router lists.

        A list that does not contain this session is too old and is ignored.
        """
        while True:
            found = self._listed(max(0.0, deadline - time.monotonic()))
            if self._own() in found or time.monotonic() >= deadline or self._session.is_closed():
                return set(found)
            with self._changed:
                self._changed.wait(_LINK_PAUSE_S)

    def _listed(self, timeout_s: float) -> dict[str, str]:
        """Return the sessions that the router lists: `peer` or `client` for each session id."""
        found: dict[str, str] = {}
        for router in self._routers():
            found |= admin_query.sessions(self._session, router, timeout_s)
        return found

    def _check(self) -> float | None:
        """Check the router and the links. Return the seconds until the next check."""
        # If an error occurs, the session was closed or the router has ended. The end of the router
        # causes another event.
        with contextlib.suppress(zenoh.ZError, SessionError):
            if not self._routers():
                self._meeting.start_router()
                return _CHECK_DELAY_S if self._meeting.uses_port else None
            if self._own() in self._listed(_ANSWER_TIMEOUT_S):
                return self._introduce_unlinked()
            if not self._session.is_closed():
                # The router accepts links, but does not answer. If it is killed, its link
                # disappears.
                self._meeting.end_stuck_router()
                return _CHECK_DELAY_S
        return None

    def _introduce_unlinked(self) -> float | None:
        """Introduce the peers that are not linked. Return the seconds until the next check."""
        # There is a maximum, because a program with its own configuration may be unreachable.
        counts = self._introductions
        unlinked = [zid for zid in self._unlinked() if counts[zid] < _MAX_INTRODUCTIONS]
        if not unlinked:
            return None
        counts.update(unlinked)
        self._introduce()
        return _CHECK_DELAY_S * (1 << min(counts[zid] for zid in unlinked))

    def _unlinked(self) -> set[str]:
        """Return the listed peers that this session is not linked to."""
        known = self._listed(_LISTING_TIMEOUT_S)
        if known.get(self._own()) != "peer":
            return set()  # a client is linked to the router only
        peers = {zid for zid, kind in known.items() if kind == "peer"}
        return peers - self._peers() - {self._own()}

    def _introduce(self) -> None:
        deadline = time.monotonic() + _INTRODUCTION_TIMEOUT_S
        with self._meeting.open_introducer():
            while self._unlinked() and time.monotonic() < deadline:
                if self._closing.wait(_INTRODUCTION_PAUSE_S):
                    return

    def _wait(self, done: Callable[[], bool], timeout_s: float) -> bool:
        deadline = time.monotonic() + timeout_s
        with self._changed:
            while not done():
                left = deadline - time.monotonic()
                if left <= 0 or self._session.is_closed():
                    return False
                self._changed.wait(min(left, _LINK_PAUSE_S))
        return True

    def join(self) -> None:
        """Wait for the thread to end. Call this after the session was closed."""
        self._closing.set()
        self._events.put(None)
        with self._changed:
            self._changed.notify_all()
        # A thread without an ident was not started, because a signal interrupted its start.
        if self._thread is not threading.current_thread() and self._thread.ident is not None:
            self._thread.join(_JOIN_TIMEOUT_S)
