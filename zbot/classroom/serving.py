"""The life of a hub's process: from its lock to its end by a signal."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import threading
from typing import TYPE_CHECKING, Any

from zbot.classroom import background
from zbot.classroom.desk import Desk
from zbot.classroom.hub import HubSettings, dialled_links, open_router
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import zenoh

#: What a hub answers to whoever asks `HUB_KEY` plus its process id.
HUB_KEY = "@hub"


class Serving:
    """A hub that is open.

    Args:
        session: The router's.
        settings: How it is linked.
    """

    def __init__(self, session: zenoh.Session, settings: HubSettings) -> None:
        self.session = session
        self._settings = settings
        self._desks = [self.desk(f"{HUB_KEY}/{os.getpid()}", self._facts)]

    def desk(self, key: str, answer: Callable[[dict[str, Any]], dict[str, Any] | None]) -> Desk:
        """Answer queries on a key for as long as the hub is open."""
        made = Desk(self.session, key, answer)
        self._desks = [*getattr(self, "_desks", []), made]
        return made

    def _facts(self, _question: dict[str, Any]) -> dict[str, Any]:
        return {
            "pid": os.getpid(),
            "host": socket.gethostname(),
            "version": __version__,
            "linked": bool(dialled_links(self.session, self._settings)),
        }

    def close(self) -> None:
        """Close the session, then wait for the desks."""
        self.session.close()
        for desk in self._desks:
            desk.join()


@contextlib.contextmanager
def ending() -> Iterator[threading.Event]:
    """Yield an event that SIGTERM and Ctrl-C set; the former handlers come back afterwards."""
    over = threading.Event()

    def end(_number: int, _frame: Any) -> None:
        over.set()

    numbers = (signal.SIGTERM, signal.SIGINT)
    before = {number: signal.signal(number, end) for number in numbers}
    try:
        yield over
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def serve(
    role: str,
    settings: HubSettings,
    on_ready: Callable[[], None],
    equip: Callable[[Serving], None] | None = None,
) -> None:
    """Be this machine's hub until a signal comes.

    Args:
        role: Shown by `zbot status`.
        settings: How it is linked.
        on_ready: Called once others can connect.
        equip: Adds what this role needs.

    Raises:
        AlreadyJoinedError: This machine has a hub.
        HubPortError: Its port is taken.
    """
    with background.the_only_one(), ending() as over:
        serving = Serving(open_router(settings), settings)
        try:
            if equip is not None:
                equip(serving)
            background.announce(role, settings.listen, settings.connect)
            on_ready()
            over.wait()
        finally:
            serving.close()
