"""The view's process, which all browsers share."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Protocol
from weakref import WeakKeyDictionary

from zbot.view.server.embedded_view import EmbeddedView
from zbot.view.server.viser_server import check_extra

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.system import System
    from zbot.web.page.panel import PageServer

#: The process stays this long after the last panel has closed, because a page may be loaded again.
LINGER_S = 30.0


class Process(Protocol):
    """The part of a `EmbeddedView` that is used here."""

    @property
    def is_running(self) -> bool:
        """Whether the process has not ended yet."""
        ...

    def address(self) -> tuple[int, str]:
        """Wait until the view can be opened. Return its port and its token."""
        ...

    def close(self) -> None:
        """End the process."""


class SharedView:
    """Process of the view, from the first open panel until some time after the last.

    Any thread may call any method.

    Args:
        start: Function that starts the process.
        linger_s: Seconds from the end of the last panel to the end of the process.
    """

    def __init__(self, start: Callable[[], Process], linger_s: float = LINGER_S) -> None:
        self._start, self._linger_s = start, linger_s
        self._lock = threading.Lock()  # held while the process starts, which takes seconds
        self._count_lock = threading.Lock()
        self._panels = 0
        self._process: Process | None = None
        self._address: tuple[int, str] | None = None
        self._timer: threading.Timer | None = None

    def open(self) -> None:
        """Count an open panel. Each panel calls `release` once when it closes."""
        with self._count_lock:
            self._panels += 1
            if self._timer is not None:
                self._timer.cancel()

    def release(self) -> None:
        """Count a closed panel."""
        with self._count_lock:
            self._panels -= 1
            if self._panels:
                return
            self._timer = threading.Timer(self._linger_s, self._end_if_unused)
            self._timer.daemon = True
            self._timer.start()

    def address(self) -> tuple[int, str]:
        """Return the port and the token of the view. Start its process if it does not run.

        This takes seconds, so call it in a thread.

        Raises:
            ViewerError: The extra `view` is not installed, or the process has ended.
        """
        check_extra()
        with self._lock:
            if self._process is None or not self._process.is_running:
                self._process, self._address = self._start(), None
            if self._address is None:
                self._address = self._process.address()
            return self._address

    @property
    def has_ended(self) -> bool:
        """Whether the process ended by itself."""
        process = self._process
        return process is not None and not process.is_running

    def _end_if_unused(self) -> None:
        with self._lock:
            if not self._panels:
                self._close()

    def close(self) -> None:
        """End the process. A second call does nothing."""
        with self._lock:
            self._close()

    def _close(self) -> None:
        process, self._process, self._address = self._process, None, None
        if process is not None:
            process.close()


#: The views of a system by domain.
_VIEWS: WeakKeyDictionary[System, dict[int, SharedView]] = WeakKeyDictionary()


def shared_view(system: System, server: PageServer, domain: int) -> SharedView:
    """Return the view of a domain. The view of another domain can only show it.

    Args:
        system: The running system.
        server: The server of the page.
        domain: The domain.
    """
    read_only = system.read_only or domain != system.domain_id

    def start() -> EmbeddedView:
        return EmbeddedView(server.host, server.port, read_only=read_only, domain=domain)

    views = _VIEWS.setdefault(system, {})
    if domain not in views:
        views[domain] = SharedView(start)
        system.context.on_shutdown(views[domain].close)
    return views[domain]
