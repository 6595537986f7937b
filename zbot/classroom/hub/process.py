"""Process of a hub. It takes the lock, opens the session, and closes the session on a signal."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import threading
import time
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.hub import running_hub
from zbot.classroom.hub.queries import HubQueries
from zbot.classroom.hub.router import HubSettings, dialled_links, open_router
from zbot.classroom.keys import HUB_KEY
from zbot.memory import give_back_freed_memory, keep_little_freed_memory
from zbot.threads.foreign_call import called_by_zenoh
from zbot.threads.wakeup import LONGEST_WAIT_S
from zbot.transport.router_renewal import CLASS_LIMIT, MACHINE_LIMIT, RouterRenewal
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

_JOIN_TIMEOUT_S = 2.0
# Other routers need up to 0.1 s to note that their links to this hub are lost. Before that, they
# would not repeat their declarations on new links (see `link_check`).
_REOPENING_PAUSE_S = 0.3


class HubProcess:
    """Hub with an open session.

    Args:
        session: The router's session.
        settings: The endpoints and Zenoh settings of the session.
        reopen: Function that closes the hub and opens it with new settings.
    """

    def __init__(
        self, session: zenoh.Session, settings: HubSettings, reopen: Callable[[], None]
    ) -> None:
        self._session: zenoh.Session | None = session
        self.reopen = reopen
        self._settings = settings
        self._threads: list[threading.Thread] = []
        self._queries: list[HubQueries] = []
        self._kept: list[object] = []
        self._ends: list[Callable[[], None]] = []
        #: Functions that return further facts for `zbot status`. The keys are names of facts.
        self.extra_facts: dict[str, Callable[[], Any]] = {}
        self._renewal = RouterRenewal(session, reopen, CLASS_LIMIT)
        self.call_on_close(self._renewal.end)
        if settings.connect:
            on_link = called_by_zenoh(self._on_link)
            self.keep(session.info.declare_transport_events_listener(on_link, history=False))
        self.answer_queries(f"{HUB_KEY}/{os.getpid()}", self._facts)
        self.answer_queries(f"{HUB_KEY}/{os.getpid()}/link", lambda _question: {})

    @property
    def session(self) -> zenoh.Session:
        """The open session. It raises `zenoh.ZError` if the hub was closed."""
        session = self._session
        if session is None:
            raise zenoh.ZError("the hub was closed")
        return session

    def _on_link(self, event: Any) -> None:
        """Renew the hub of one machine right after its router.

        Both see the same tokens, so otherwise they would be renewed at the same time. If two linked
        routers close at the same time, a thread of Zenoh panics (docs/design/zenoh-faults.md).
        """
        is_router = event.transport.whatami == zenoh.WhatAmI.ROUTER
        if is_router and event.kind == zenoh.SampleKind.PUT:
            # The router has seen at least twice as many tokens.
            self._renewal.renew_after(MACHINE_LIMIT // 4)

    def keep(self, entity: object) -> None:
        """Keep a subscriber, a token or a listener of the session until the hub is closed."""
        self._kept.append(entity)

    def answer_queries(
        self, key: str, answer: Callable[[dict[str, Any]], dict[str, Any] | None]
    ) -> None:
        """Answer queries on a key while the hub is open."""
        queries = HubQueries(self.session, key, answer)
        self._queries.append(queries)
        self._threads.append(queries.thread)

    def start_thread(self, name: str, run: Callable[..., object], *arguments: object) -> None:
        """Run a function in a thread. The function must end when the session is closed."""
        thread = threading.Thread(target=run, args=arguments, name=name, daemon=True)
        thread.start()
        self._threads.append(thread)

    def call_on_close(self, end: Callable[[], None]) -> None:
        """Let `close` call a function before it closes the session."""
        self._ends.append(end)

    def is_linked(self) -> bool:
        """Return whether this hub has a link to the hub that it dials."""
        return bool(dialled_links(self.session, self._settings))

    def _facts(self, _question: dict[str, Any]) -> dict[str, Any]:
        return {
            "pid": os.getpid(),
            "host": socket.gethostname(),
            "version": __version__,
            "linked": self.is_linked(),
            **{name: find() for name, find in self.extra_facts.items()},
        }

    def close(self) -> None:
        """Finish the query in progress, close the session, then wait for the threads.

        Zenoh frees the keys and the access rules of a session after nothing refers to the session
        or to one of its entities. The rules of a class take 40 MB.
        """
        for end in self._ends:
            end()
        for queries in self._queries:
            queries.finish()
        self.session.close()
        self._session = None
        for thread in self._threads:
            thread.join(_JOIN_TIMEOUT_S)
        for referring in (self._threads, self._queries, self._kept, self._ends):
            referring.clear()


class _Signals:
    """Events that the process waits for: a signal to end, or a request to reopen the hub."""

    def __init__(self) -> None:
        self.is_over = False
        self._happened = threading.Event()

    def reopen(self) -> None:
        self._happened.set()

    def end(self, _number: int, _frame: Any) -> None:
        self.is_over = True
        self._happened.set()

    def begin(self) -> bool:
        """Forget requests to reopen the hub. Return whether the process shall go on.

        A hub that is opened now has the newest settings, so it must not be reopened for a request
        that came while the former hub was being closed.
        """
        self._happened.clear()
        return not self.is_over

    def wait(self) -> None:
        while not self._happened.wait(LONGEST_WAIT_S):
            continue


@contextlib.contextmanager
def _signals() -> Iterator[_Signals]:
    """Yield the events that SIGTERM and SIGINT set. Restore the former handlers afterwards."""
    caught = _Signals()
    numbers = (signal.SIGTERM, signal.SIGINT)
    before = {number: signal.signal(number, caught.end) for number in numbers}
    try:
        yield caught
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def serve(
    role: str,
    settings: Callable[[], HubSettings],
    on_ready: Callable[[], None],
    attach: Callable[[HubProcess], None] | None = None,
) -> None:
    """Run this machine's hub until SIGTERM or SIGINT.

    Args:
        role: Shown by `zbot status`.
        settings: Returns the hub's settings. It is called each time that the hub is opened.
        on_ready: Called once, when nodes and other hubs can connect.
        attach: Adds the parts that this role needs. It is called each time that the hub is opened.

    Raises:
        ClassroomError: This machine runs a hub already, or another program uses the port.
    """
    keep_little_freed_memory()
    with running_hub.hub_lock(), _signals() as signals:
        report: Callable[[], None] | None = on_ready
        while signals.begin():
            present = settings()
            serving = HubProcess(open_router(present), present, signals.reopen)
            try:
                if attach is not None:
                    attach(serving)
                running_hub.write_state(role, present.listen, present.connect)
                if report is not None:
                    report()
                signals.wait()
            finally:
                serving.close()
            give_back_freed_memory()  # before the new session takes memory
            report = None
            if not signals.is_over:
                time.sleep(_REOPENING_PAUSE_S)


def serve_session(open_session: Callable[[], zenoh.Session], on_ready: Callable[[], None]) -> None:
    """Keep a session open until SIGTERM or SIGINT.

    Args:
        open_session: Opens the session.
        on_ready: Called when the session is open.
    """
    with _signals() as signals, open_session():
        on_ready()
        signals.wait()
