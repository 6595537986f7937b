"""The life of a hub's process: from its lock to its end by a signal."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import sys
import threading
from typing import TYPE_CHECKING, Any

from zbot.classroom import background
from zbot.classroom.hub import HubSettings, dialled_links, open_router
from zbot.classroom.hub_queries import HubQueries
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import zenoh

#: What a hub answers to whoever asks `HUB_KEY` plus its process id.
HUB_KEY = "@hub"


_JOIN_TIMEOUT_S = 2.0
# On Windows a thread that waits without end does not see Ctrl-C.
_TICK_S = 0.5 if sys.platform == "win32" else None


class HubProcess:
    """A hub that is open.

    Args:
        session: The router's.
        settings: How it is linked.
        wake: Called to have the hub opened anew, with new settings.
    """

    def __init__(
        self, session: zenoh.Session, settings: HubSettings, wake: Callable[[], None]
    ) -> None:
        self.session = session
        self.reopen = wake
        self._settings = settings
        self._threads: list[threading.Thread] = []
        self._desks: list[HubQueries] = []
        self.tell: dict[str, Callable[[], Any]] = {}  #: more that `zbot status` shows, by name
        self.desk(f"{HUB_KEY}/{os.getpid()}", self._facts)

    def desk(self, key: str, answer: Callable[[dict[str, Any]], dict[str, Any] | None]) -> None:
        """Answer queries on a key for as long as the hub is open."""
        desk = HubQueries(self.session, key, answer)
        self._desks.append(desk)
        self.join_later(desk.thread)

    def join_later(self, thread: threading.Thread) -> None:
        """Wait, when the hub is closed, for a thread that ends with the session."""
        self._threads.append(thread)

    def _facts(self, _question: dict[str, Any]) -> dict[str, Any]:
        return {
            "pid": os.getpid(),
            "host": socket.gethostname(),
            "version": __version__,
            "linked": bool(dialled_links(self.session, self._settings)),
            **{name: find() for name, find in self.tell.items()},
        }

    def close(self) -> None:
        """Close the session once nobody waits for an answer, then wait for the threads."""
        for desk in self._desks:
            desk.finish()
        self.session.close()
        for thread in self._threads:
            thread.join(_JOIN_TIMEOUT_S)


class _Signals:
    """What the process waits for: its end, or a wish to be opened anew."""

    def __init__(self) -> None:
        self.is_over = False
        self._happened = threading.Event()

    def reopen(self) -> None:
        self._happened.set()

    def end(self, _number: int, _frame: Any) -> None:
        self.is_over = True
        self._happened.set()

    def wait(self) -> None:
        while not self._happened.wait(_TICK_S):
            continue
        self._happened.clear()


@contextlib.contextmanager
def _signals() -> Iterator[_Signals]:
    """Yield what SIGTERM and Ctrl-C set; the former handlers come back afterwards."""
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
    equip: Callable[[HubProcess], None] | None = None,
) -> None:
    """Be this machine's hub until a signal comes.

    Args:
        role: Shown by `zbot status`.
        settings: Returns how it is linked; asked again when it is opened anew.
        on_ready: Called once others can connect.
        equip: Adds what this role needs, each time it is opened.

    Raises:
        AlreadyJoinedError: This machine has a hub.
        HubPortError: Its port is taken.
    """
    with background.the_only_one(), _signals() as signals:
        tell = on_ready
        while not signals.is_over:
            present = settings()
            serving = HubProcess(open_router(present), present, signals.reopen)
            try:
                if equip is not None:
                    equip(serving)
                background.announce(role, present.listen, present.connect)
                tell()
                signals.wait()
            finally:
                serving.close()
            tell = _say_nothing


def _say_nothing() -> None:
    """Stand in for `on_ready` when the hub is opened again."""
