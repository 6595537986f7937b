"""Peering of a session: keeps a router on the domain's port, and links the session to all peers.

The router tells each pair of peers in a domain about each other once. Then one peer of the pair
tries once to connect to the other. If a peer is too busy to answer in time, for example on a laptop
that starts twenty programs, Zenoh does not try again. This module does.
"""

from __future__ import annotations

import contextlib
import threading
from collections import Counter, deque
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

import zenoh

from zbot.errors import SetupError
from zbot.threads.deadline import Deadline
from zbot.threads.foreign_call import without_interruption
from zbot.threads.on_demand_thread import OnDemandThread
from zbot.threads.unawaited_thread import UnawaitedThread
from zbot.transport import admin_query, background_process
from zbot.transport.errors import SessionError
from zbot.transport.session import LINK_TIMEOUT_S

if TYPE_CHECKING:
    from collections.abc import Callable

# Pause between attempts to open the router. When two processes take a port within the same
# microseconds, Linux may refuse the port to both. This happens in 6 of 100 starts of launch files.
_HOLD_PAUSE_S = 0.1
# Zenoh changes its lists of links a short time after it reports a new or lost link.
_LINK_PAUSE_S = 0.005
_LISTING_TIMEOUT_S = 0.1
_ANSWER_TIMEOUT_S = 1.0  # a router answers within 3 ms, on a busy machine within half a second
_LONGEST_PAUSE_S = 1.0
# After this time, a linked peer has sent its declarations, even if it does not answer queries.
_SILENT_S = 0.1
# A session whose links have not changed for this time looks for peers that it has no link to.
_CHECK_DELAY_S = 1.0
# A session introduces each peer without a link at most this number of times. The pause doubles
# after each introduction. Dead peers are introduced too, because the router lists them for 10 s.
_MAX_INTRODUCTIONS = 5
_INTRODUCTION_TIMEOUT_S = 2.0  # an introduction usually takes 50 ms
_INTRODUCTION_PAUSE_S = 0.02
# A router's clients check whether the router is suspended. One client is enough to replace the
# router. So each client checks rarely, and all clients together check eight times a second. A peer
# does not check, because its messages do not go through the router.
_WATCH_PAUSE_S = 1.0
_WATCHES_PER_S = 8
_LONGEST_WATCH_PAUSE_S = 10.0
_JOIN_TIMEOUT_S = 2.0  # the thread ends within a millisecond after its session


class Meeting(Protocol):
    """Place where the sessions of a domain find each other."""

    @property
    def uses_port(self) -> bool:
        """Whether the domain's programs open the router themselves."""
        ...

    def start_router(self) -> bool:
        """Start the router if no router runs and a program may start it."""
        ...

    def end_stuck_router(self) -> bool:
        """End a router that does not answer, if a program may end it."""
        ...

    def end_stopped_router(self) -> bool:
        """End a router that is suspended, if a program may end it."""
        ...

    def open_introducer(self) -> zenoh.Session:
        """Open a session that introduces peers to each other."""
        ...

    def warn_unanswered(self) -> None:
        """Log once that no router answers."""
        ...


class Peering:
    """Keeps a router on the domain's port, and links to all peers, until the session is closed.

    Zenoh tells when links appear and disappear. Then one thread works until nothing is left to do.
    When the link to the router has disappeared, the thread tries to open a router on the port, and
    exactly one of the domain's processes succeeds. When the links have not changed for a time, the
    thread asks the router for its peers. If a link to any of these peers is missing, the thread
    opens an introducer session, which introduces the peers to each other again.

    Args:
        session: The session.
        meeting: The place where the sessions of the domain find each other.
        receiver: Turns a function into a callback that Zenoh calls until the session is closed.
    """

    def __init__(
        self,
        session: zenoh.Session,
        meeting: Meeting,
        receiver: Callable[[Callable[[Any], None]], Any],
    ) -> None:
        self._session = session
        self._meeting = meeting
        self._receiver = receiver
        self._changed = threading.Event()
        self._events: deque[Any] = deque()
        self._check_time = Deadline(_CHECK_DELAY_S)
        self._introductions: Counter[str] = Counter()  # how often each session was introduced
        self._closing = threading.Event()
        self._watch_pause_s: float | None = None  # set while this session is a linked client
        # The delays differ, so that not all sessions open an introducer at the same time.
        self._extra_delay = int(self._own()[:4], 16) / 0x10000
        self._thread: threading.Thread | None = None
        self._work = OnDemandThread(self._start_thread, self._turn)

    def start(self) -> None:
        """Begin to work."""
        listen = self._session.info.declare_transport_events_listener
        without_interruption(listen, self._receiver(self._on_event), history=True)
        self._work.wake()

    def _start_thread(self, run: Callable[[], None]) -> None:
        thread = UnawaitedThread(run, "zbot meeting")
        without_interruption(thread.start)
        self._thread = thread

    def _on_event(self, event: Any) -> None:
        # Zenoh may hold a lock during this call. So the call must not wait for a thread that calls
        # Zenoh.
        self._events.append(event)
        self._changed.set()
        self._work.wake()

    def _turn(self) -> float | None:
        """React to events, or check the links. Return the seconds until the next check, if any."""
        if self._closing.is_set():
            return None
        if self._events:
            self._watch_pause_s = None
            pause_s = self._attempt(partial(self._react, self._events.popleft()))
        elif not self._check_time.is_over:
            return self._check_time.left_s
        else:
            pause_s = self._attempt(self._check)
        if pause_s is None:
            return None
        self._check_time = Deadline(pause_s * (1 + self._extra_delay))
        return 0.0 if self._events else self._check_time.left_s

    def _attempt(self, work: Callable[[], float | None]) -> float | None:
        """Do a part of the thread's work. If it fails, let the thread check everything later.

        The work opens files, and fails if the process has no free file descriptor at this moment.
        """
        try:
            return work()
        except (OSError, SetupError) as exc:
            from zbot.log import warn_once  # noqa: PLC0415 - seldom used

            warn_once(f"cannot look for other programs ({exc}): trying again each second")
            return _CHECK_DELAY_S

    def _react(self, event: Any) -> float:
        if event.kind == zenoh.SampleKind.DELETE:
            self._replace_router(str(event.transport.zid))
        return _CHECK_DELAY_S

    def _replace_router(self, gone: str) -> None:
        self._wait(lambda: gone not in self._routers(), _LISTING_TIMEOUT_S)
        # The links of a killed process end a short time before its port is free. After another
        # process has got the port, this session needs a short time to link to that process.
        pause_s = _LINK_PAUSE_S
        while not (self._session.is_closed() or self._routers()):
            self._meeting.start_router()
            if self._closing.wait(pause_s):
                return
            if pause_s == _LONGEST_PAUSE_S:
                self._meeting.end_stuck_router()  # it has the port, but accepts no links
            pause_s = min(2 * pause_s, _LONGEST_PAUSE_S)

    def _own(self) -> str:
        return str(self._session.info.zid())

    def _routers(self) -> set[str]:
        return {str(zid) for zid in self._session.info.routers_zid()}

    def _peers(self) -> set[str]:
        return {str(zid) for zid in self._session.info.peers_zid()}

    def link(self, is_over: Callable[[], bool]) -> None:
        """Wait until the session is linked to the domain's router, and start one if necessary.

        Args:
            is_over: Returns whether the context was shut down. If it was, the wait ends.
        """
        meeting, deadline = self._meeting, Deadline(LINK_TIMEOUT_S)
        pause_s = _HOLD_PAUSE_S
        if not meeting.uses_port:
            return
        while not self.wait_for_router(min(pause_s, deadline.left_s)):
            if is_over():
                return
            if deadline.is_over:
                meeting.warn_unanswered()
                return
            meeting.end_stuck_router()
            meeting.start_router()
            pause_s *= 2

    def wait_for_router(self, timeout_s: float) -> bool:
        """Wait until the session is linked to a router. Return `False` if the time is over."""
        return self._wait(lambda: bool(self._routers()), timeout_s)

    def wait_for_answers(self, timeout_s: float) -> bool:
        """Send a query to all peers that the router lists, and wait for their answers.

        A client waits only for the router, because the router already has the declarations of all
        peers. An answer arrives after all declarations that its sender made before. So after the
        last answer, this session knows all subscriptions of the peers. The wait takes 5 to 30 ms
        after a session was opened.
        """
        deadline = Deadline(timeout_s)
        if not self.wait_for_router(timeout_s):
            return False
        answered = {self._own()}
        missing = self._mesh_at_router(deadline) - answered
        silence = Deadline(_SILENT_S)
        while missing:
            if not self._meeting.uses_port and silence.is_over:
                answered |= self._peers()  # some programs without zbot have no admin space
                missing -= answered
                if not missing:
                    break
            left_s = deadline.left_s
            if not left_s:
                return False
            answers = admin_query.answers(self._session, "@/*/peer", left_s)
            answered |= {key.split("/")[1] for key, _ in answers}
            if missing <= answered:
                break
            self._wait_for_change(_LINK_PAUSE_S)
            missing = self._mesh_at_router(deadline) - answered  # sessions may have ended
        return True

    def _mesh_at_router(self, deadline: Deadline) -> set[str]:
        """Return the ids of the peers that the meeting router lists, or an empty set for a client.

        A list that does not contain this session is too old and is ignored.
        """
        while True:
            found = self._listed(deadline.left_s)
            if self._own() in found or deadline.is_over or self._session.is_closed():
                if found.get(self._own()) == "client":
                    return set()
                return {zid for zid, kind in found.items() if kind == "peer"}
            self._wait_for_change(_LINK_PAUSE_S)

    def _listed(self, timeout_s: float) -> dict[str, str]:
        """Return the sessions that the router lists: `peer` or `client` for each session id."""
        found: dict[str, str] = {}
        for router in self._routers():
            found |= admin_query.sessions(self._session, router, timeout_s)
        return found

    def _check(self) -> float | None:
        """Check the router and the links. Return the seconds until the next check."""
        if self._meeting.end_stopped_router():  # then the session loses its link to the router
            return _CHECK_DELAY_S
        if self._watch_pause_s is not None:
            return self._watch_pause_s
        background_process.reap()  # a router that this process had started may have been killed
        # If an error occurs, the session was closed or the router has ended. The end of the router
        # causes another event.
        with contextlib.suppress(zenoh.ZError, SessionError):
            if not self._routers():
                self._meeting.start_router()
                return _CHECK_DELAY_S if self._meeting.uses_port else None
            listed = self._listed(_ANSWER_TIMEOUT_S)
            if listed.get(self._own()) == "client":
                clients = list(listed.values()).count("client")
                pause_s = max(_WATCH_PAUSE_S, clients / _WATCHES_PER_S)
                self._watch_pause_s = min(pause_s, _LONGEST_WATCH_PAUSE_S)
                return self._watch_pause_s
            if listed.get(self._own()) == "peer":
                return self._introduce_unlinked(self._unlinked(listed))
            if not self._session.is_closed():
                # The router accepts links, but does not answer. When it is killed, the session
                # loses its link to the router.
                self._meeting.end_stuck_router()
                return _CHECK_DELAY_S
        return None

    def _introduce_unlinked(self, unlinked: set[str]) -> float | None:
        """Introduce the peers that are not linked. Return the seconds until the next check."""
        # Each peer is introduced a limited number of times, because a program with a Zenoh
        # configuration of its own may never be reachable.
        counts = self._introductions
        chosen = [zid for zid in unlinked if counts[zid] < _MAX_INTRODUCTIONS]
        if not chosen:
            return None
        counts.update(chosen)
        self._introduce()
        return _CHECK_DELAY_S * (1 << min(counts[zid] for zid in chosen))

    def _unlinked(self, listed: dict[str, str]) -> set[str]:
        """Return the peers in the router's list that this session is not linked to."""
        if listed.get(self._own()) != "peer":
            return set()  # a client is linked to the router only
        peers = {zid for zid, kind in listed.items() if kind == "peer"}
        return peers - self._peers() - {self._own()}

    def unreachable(self) -> set[str]:
        """Return the peers that the router lists, but to which this session has no link.

        In a domain of zbot, this returns an empty set, because this module links such peers itself.
        """
        if self._meeting.uses_port:
            return set()
        with contextlib.suppress(zenoh.ZError):  # the session was closed
            return self._unlinked(self._listed(_ANSWER_TIMEOUT_S))
        return set()

    def _introduce(self) -> None:
        deadline = Deadline(_INTRODUCTION_TIMEOUT_S)
        with self._meeting.open_introducer():
            while self._unlinked(self._listed(_ANSWER_TIMEOUT_S)) and not deadline.is_over:
                if self._closing.wait(_INTRODUCTION_PAUSE_S):
                    return

    def _wait(self, done: Callable[[], bool], timeout_s: float) -> bool:
        deadline = Deadline(timeout_s)
        while not done():
            if deadline.is_over or self._session.is_closed():
                return False
            self._wait_for_change(min(deadline.left_s, _LINK_PAUSE_S))
        return True

    def _wait_for_change(self, timeout_s: float) -> None:
        self._changed.clear()
        self._changed.wait(timeout_s)

    def join(self) -> None:
        """Wait for the thread to end. Call this after the session was closed."""
        self._closing.set()
        self._changed.set()
        self._work.end()
        thread = self._thread
        if thread is not None and thread is not threading.current_thread():
            thread.join(_JOIN_TIMEOUT_S)
