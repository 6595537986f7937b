"""What a session does so that its domain stays whole: it minds the meeting port, and who is linked.

The meeting router introduces the domain's peers to each other, once. Zenoh dials once, too: where
both sides of an introduction are too busy to answer the other's call in time, as on a laptop that
starts twenty programs, they would not hear each other for as long as they live.
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
from zbot.transport.foreign_call import in_one_go

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.transport.session import MeetingPoint

# Links are listed, and listed no more, a moment after their event.
_LINK_PAUSE_S = 0.005
_LISTING_TIMEOUT_S = 0.1
_LONGEST_PAUSE_S = 1.0
# So long no link has come or gone when a session looks for those whom it never met. It has each of
# them introduced so often, at intervals that double; one that is dead is listed for 10 s.
_QUIET_S = 1.0
_TRIES = 5
_INTRODUCTION_S = 2.0  # 50 ms are usual
_INTRODUCTION_PAUSE_S = 0.02
_END_S = 2.0  # the thread ends within a millisecond of its session


class Peering:
    """Keeps the meeting port open, and the session linked to all others, for as long as it lives.

    One thread waits, without polling, for links to come and go. When the router's link goes, it
    tries to take the port, and exactly one of the domain's processes succeeds. Once all is quiet
    after that, it looks whether the router knows somebody whom its session does not, and sends for
    an introducer then.

    Args:
        session: The session that is looked after.
        meeting: Where its domain meets.
        receiver: Makes a function into what Zenoh calls until the session is closed.
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
        self._tries: Counter[str] = Counter()
        self._closing = threading.Event()
        listen = session.info.declare_transport_events_listener
        in_one_go(listen, receiver(self._on_event), history=True)
        # Not all look at the same time, because one introducer serves everybody.
        self._share = int(self._own()[:4], 16) / 0x10000
        self._thread = threading.Thread(target=self._run, name="zbot meeting", daemon=True)

    def start(self) -> None:
        """Begin to watch."""
        in_one_go(self._thread.start)

    def _on_event(self, event: Any) -> None:
        self._events.put(event)
        with self._changed:
            self._changed.notify_all()

    def _run(self) -> None:
        timeout_s: float | None = None
        while True:
            try:
                event = self._events.get(timeout=timeout_s)
            except queue.Empty:
                pause_s = self._meet_strangers()
            else:
                if event is None:
                    return
                if event.kind == zenoh.SampleKind.DELETE:
                    self._replace_router(str(event.transport.zid))
                pause_s = _QUIET_S
            timeout_s = None if pause_s is None else pause_s * (1 + self._share)

    def _replace_router(self, gone: str) -> None:
        self._wait(lambda: gone not in self._routers(), _LISTING_TIMEOUT_S)
        # A process that is killed loses its links a moment before its port, and whoever takes the
        # port before us needs a moment to be linked.
        pause_s = _LINK_PAUSE_S
        while not (self._session.is_closed() or self._routers() or self._meeting.hold()):
            if self._closing.wait(pause_s):
                return
            pause_s = min(2 * pause_s, _LONGEST_PAUSE_S)

    # -- who is there --------------------------------------------------------------------------

    def _own(self) -> str:
        return str(self._session.info.zid())

    def _routers(self) -> set[str]:
        return {str(zid) for zid in self._session.info.routers_zid()}

    def _peers(self) -> set[str]:
        return {str(zid) for zid in self._session.info.peers_zid()}

    def wait_linked(self, timeout_s: float) -> bool:
        """Wait until the session has a link to a router; `False` if none came in time."""
        return self._wait(lambda: bool(self._routers()), timeout_s)

    def wait_settled(self, timeout_s: float) -> bool:
        """Wait until every session that the meeting router knows has answered a query.

        The answer comes behind what its sender declared before, so from then on a message that is
        published reaches the subscribers that it had. Takes 5 to 30 ms after a session was opened.
        """
        deadline = time.monotonic() + timeout_s
        if not self.wait_linked(timeout_s):
            return False
        met = {self._own()}
        missing = self._at_router(deadline) - met
        while missing:
            left = deadline - time.monotonic()
            if left <= 0:
                return False
            met |= {
                key.split("/")[1] for key, _ in admin_query.answers(self._session, "@/*/*", left)
            }
            if missing <= met:
                break
            with self._changed:
                self._changed.wait(_LINK_PAUSE_S)
            missing = self._at_router(deadline) - met  # somebody may have gone
        return True

    def _at_router(self, deadline: float) -> set[str]:
        """Return the sessions that the meeting router lists.

        It lists this one, too, as soon as it answers at all: what it says before is no answer.
        """
        while True:
            found = self._listed(max(0.0, deadline - time.monotonic()))
            if self._own() in found or time.monotonic() >= deadline or self._session.is_closed():
                return set(found)
            with self._changed:
                self._changed.wait(_LINK_PAUSE_S)

    def _listed(self, timeout_s: float) -> dict[str, str]:
        """Return what the router knows: peers and clients, by session id."""
        found: dict[str, str] = {}
        for router in self._routers():
            found |= admin_query.sessions(self._session, router, timeout_s)
        return found

    # -- introductions -------------------------------------------------------------------------

    def _meet_strangers(self) -> float | None:
        """Have those introduced whom its session never met; return when to look again, if ever."""
        # An error: the session was closed, or the router has just gone, which is an event.
        with contextlib.suppress(zenoh.ZError, SessionError):
            # A program with a configuration of its own may be out of everybody's reach.
            strangers = [one for one in self._strangers() if self._tries[one] < _TRIES]
            if strangers:
                self._tries.update(strangers)
                self._call_introducer()
                return _QUIET_S * (1 << min(self._tries[one] for one in strangers))
        return None

    def _strangers(self) -> set[str]:
        """Return the peers that the router knows and this one is not linked to."""
        known = self._listed(_LISTING_TIMEOUT_S)
        if known.get(self._own()) != "peer":
            return set()  # a client is linked to the router alone
        peers = {zid for zid, kind in known.items() if kind == "peer"}
        return peers - self._peers() - {self._own()}

    def _call_introducer(self) -> None:
        deadline = time.monotonic() + _INTRODUCTION_S
        with self._meeting.open_introducer():
            while self._strangers() and time.monotonic() < deadline:
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
        """Wait for the thread to end; call it after the session was closed."""
        self._closing.set()
        self._events.put(None)
        with self._changed:
            self._changed.notify_all()
        # One whose start was interrupted by a signal has no ident.
        if self._thread is not threading.current_thread() and self._thread.ident is not None:
            self._thread.join(_END_S)
