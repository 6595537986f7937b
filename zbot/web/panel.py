"""What a panel of the page is made of, and what the page gives it."""

from __future__ import annotations

import json
import time
import traceback
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from nicegui import ui

from zbot.log import get_logger
from zbot.web.pace import Pace

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from nicegui import Client

    from zbot.web.system import System
    from zbot.web.watch import Watch


@dataclass(frozen=True, slots=True)
class Panel:
    """One page of the live page, with an address of its own."""

    path: str  #: `/topics`
    title: str
    icon: str  #: name of a Material icon: `hub`
    build: Callable[[Frame], None]  #: fills the page; called inside its body, once a browser


class Releasable(Protocol):
    """A watch, a lease: what has to be released."""

    def release(self) -> None:
        """Need it no more; may be called twice."""


ReleasableT = TypeVar("ReleasableT", bound=Releasable)


class Frame:
    """One browser's page around a panel. Its methods belong to NiceGUI's loop.

    The browser asks for what is new when it is about to draw, and asks again when it has drawn the
    answer. Nothing is sent unasked: a hidden, slow or vanished browser has nothing waiting for it.

    Args:
        client: NiceGUI's view of the browser.
        system: The running system.
        query: What stands behind the `?` of the address.

    Attributes:
        system: The running system.
        query: What stands behind the `?` of the address, e.g. `{"topic": "/scan"}`.
        toolbar: A row beside the title, for buttons and filters: `with frame.toolbar: ...`
        command: The command that does what the page shows.
    """

    toolbar: ui.element

    def __init__(self, client: Client, system: System, query: Mapping[str, str]) -> None:
        self.system = system
        self.query = dict(query)
        self.command = ""
        self._client = client
        self._pace = Pace(self._on_fault)
        self._on_close: list[Callable[[], None]] = []
        self._kept: dict[Releasable, None] = {}
        self._watches: dict[Watch, bool] = {}  # whether also while the page is hidden
        self._is_awake = False
        self._show: Callable[[str], object] | None = None
        ui.on("zbot_ask", self._on_ask)
        ui.on("zbot_sleep", self._sleep)
        client.on_delete(self.close)

    @property
    def read_only(self) -> bool:
        """Whether the page may only look."""
        return self.system.read_only

    def show_command(self, command: str) -> None:
        """Show which `zbot ...` command does the same as the user's last click."""
        self.command = command
        if self._show is not None:
            self._show(command)

    def on_command(self, show: Callable[[str], object]) -> None:
        """Set what shows commands; the page around the panel does."""
        self._show = show
        show(self.command)

    # -- drawing -------------------------------------------------------------------------------

    def live(self, update: Callable[[], None], max_hz: float = 30.0) -> Callable[[], None]:
        """Call a function when the browser wants to draw, at most `max_hz` times a second.

        It runs in NiceGUI's loop and changes elements. It must be quick, and should change nothing
        when nothing is new (`Watch.count`, `System.revision`): the browser then asks less often.
        One that raises is shown in the page and not called again.

        Returns:
            A function that ends this; it may be called twice.
        """
        return self._pace.add(update, max_hz)

    def call(self, function: str, *arguments: Any) -> None:
        """Call a function of the page's scripts, with values that JSON has.

        This is the way for data that should not pass through elements: `frame.call("zbot.f", 1)`.
        """
        # JSON is JavaScript; a message's text stays a string in it.
        words = ",".join(json.dumps(one) for one in arguments)
        self._client.run_javascript(f"{function}({words})")

    def _on_ask(self) -> None:
        if not self._is_awake:
            self._wake()
        outbox = self._client.outbox
        self._pace.run(time.monotonic())
        is_changed = bool(outbox.updates or outbox.messages)
        # NiceGUI sends changes first: the browser gets this when it has drawn them.
        self._client.run_javascript(f"zbot.answered({str(is_changed).lower()})")

    def _on_fault(self, error: Exception) -> None:
        trace = "".join(traceback.format_exception(error))
        get_logger("zbot.web").error(f"a part of the page stopped\n{trace}")
        with self._client:
            ui.notify(
                f"This part of the page has stopped: {error}",
                type="negative",
                timeout=0,
                close_button=True,
            )

    # -- watching ------------------------------------------------------------------------------

    def watch(
        self, topic: str, type_name: str | None = None, *, keep: int = 0, even_hidden: bool = False
    ) -> Watch:
        """Watch a topic while the page is seen; it is released when the page is closed.

        Args:
            topic: Full name.
            type_name: Full name of its type; the one that the graph tells if left out.
            keep: How many messages to keep for `Watch.since`.
            even_hidden: Whether messages are wanted while the page is hidden behind others.
        """
        watch = self.system.watch(topic, type_name, keep=keep, is_active=self._is_awake)
        self._watches[watch] = even_hidden
        return self.keep(watch)

    def _wake(self) -> None:
        self._is_awake = True
        for watch in list(self._watches):
            watch.resume()

    def _sleep(self) -> None:
        self._is_awake = False
        for watch, even_hidden in list(self._watches.items()):
            if not even_hidden:
                watch.pause()

    # -- the end -------------------------------------------------------------------------------

    def keep(self, thing: ReleasableT) -> ReleasableT:
        """Release a watch or a lease when the page is closed, if it was not dropped; return it."""
        self._kept[thing] = None
        return thing

    def drop(self, thing: Releasable) -> None:
        """Release a watch or a lease now; nothing happens if that has been done."""
        self._kept.pop(thing, None)
        self._watches.pop(thing, None)  # type: ignore[call-overload] # or it is none
        thing.release()

    def on_close(self, callback: Callable[[], None]) -> None:
        """Call a function when this page is closed or reloaded, or its browser has vanished."""
        self._on_close.append(callback)

    def close(self) -> None:
        """Run what was given to `on_close`; may be called twice."""
        callbacks, self._on_close = self._on_close, []
        for callback in reversed(callbacks):
            callback()
        for thing in list(self._kept):
            self.drop(thing)
