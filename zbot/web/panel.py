"""What a panel of the page is made of, and what the page gives it."""

from __future__ import annotations

import json
import time
import traceback
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, TypeVar, cast

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


class Part:
    """Something of a page that can end before the page does: the details of what was chosen.

    Its methods belong to NiceGUI's loop.
    """

    def __init__(self, frame: Frame) -> None:
        self.frame = frame
        self._endings: dict[object, Callable[[], object]] = {}

    @property
    def system(self) -> System:
        """The running system."""
        return self.frame.system

    def live(self, update: Callable[[], None], max_hz: float = 30.0) -> Callable[[], None]:
        """Call a function when the browser wants to draw, at most `max_hz` times a second.

        It runs in NiceGUI's loop and changes elements. It must be quick, and should change nothing
        when nothing is new (`Watch.count`, `System.revision`): the browser then asks less often.
        One that raises is shown in the page and not called again.

        Returns:
            A function that ends this; it may be called twice.
        """
        undo = self.frame.pace.add(update, max_hz)
        return self.on_close(undo)

    def watch(
        self, topic: str, type_name: str | None = None, *, keep: int = 0, even_hidden: bool = False
    ) -> Watch:
        """Watch a topic while the page is seen; it is released when this is closed.

        Args:
            topic: Full name.
            type_name: Full name of its type; the one that the graph tells if left out.
            keep: How many messages to keep for `Watch.since`.
            even_hidden: Whether messages are wanted while the page is hidden behind others.
        """
        is_awake = self.frame.is_awake
        watch = self.system.watch(topic, type_name, keep=keep, is_active=is_awake)
        self.frame.watches[watch] = even_hidden
        return self.keep(watch)

    def keep(self, thing: ReleasableT) -> ReleasableT:
        """Release a watch or a lease when this is closed, if it was not dropped; return it."""
        self._endings[thing] = thing.release
        return thing

    def drop(self, thing: Releasable) -> None:
        """Release a watch or a lease now; nothing happens if that has been done."""
        self._endings.pop(thing, None)
        self.frame.watches.pop(thing, None)
        thing.release()

    def on_close(self, callback: Callable[[], object]) -> Callable[[], None]:
        """Call a function when this is closed.

        Returns:
            A function that calls it now instead; it may be called twice.
        """
        key = object()
        self._endings[key] = callback

        def end() -> None:
            ending = self._endings.pop(key, None)
            if ending is not None:
                ending()

        return end

    def part(self) -> Part:
        """Return a part that ends with this one, or earlier by its `close`."""
        part = Part(self.frame)
        self._endings[part] = part.close
        return part

    def close(self) -> None:
        """End everything that was begun here; may be called twice."""
        while self._endings:
            thing, end = self._endings.popitem()
            self.frame.watches.pop(thing, None)
            end()


class Frame(Part):
    """One browser's page around a panel.

    The browser asks for what is new when it is about to draw, and asks again when it has drawn the
    answer. Nothing is sent unasked: a hidden, slow or vanished browser has nothing waiting for it.
    When the page is closed or reloaded, or its browser has vanished, it is closed.

    Args:
        client: NiceGUI's view of the browser.
        system: The running system.
        query: What stands behind the `?` of the address.

    Attributes:
        query: What stands behind the `?` of the address, e.g. `{"topic": "/scan"}`.
        toolbar: A row beside the title, for buttons and filters: `with frame.toolbar: ...`
        command: The command that does what the page shows.
        is_awake: Whether somebody sees the page.
    """

    toolbar: ui.element

    def __init__(self, client: Client, system: System, query: Mapping[str, str]) -> None:
        super().__init__(self)
        self._system = system
        self.query = dict(query)
        self.command = ""
        self.is_awake = False
        self.pace = Pace(self._on_fault)
        self.watches: dict[object, bool] = {}  #: whether also while the page is hidden
        self._client = client
        self._choosers: dict[str, Callable[[str], None]] = {}
        self._show: Callable[[str], object] | None = None
        ui.on("zbot_ask", self._on_ask)
        ui.on("zbot_sleep", self._sleep)
        ui.on("zbot_choose", self._chose)
        client.on_delete(self.close)

    @property
    def system(self) -> System:
        """The running system."""
        return self._system

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

    def on_choose(self, element_id: str, choose: Callable[[str], None]) -> None:
        """Call a function with the key of a row that was clicked in a table; see `Table`."""
        self._choosers[element_id] = choose

    def _chose(self, event: Any) -> None:
        element_id, key = event.args
        if element_id in self._choosers:
            self._choosers[element_id](str(key))

    # -- drawing -------------------------------------------------------------------------------

    def set_query(self, **query: str) -> None:
        """Change what stands behind the `?` of the address, so that a reload shows the same."""
        self.query = query
        self.call("zbot.setQuery", query)

    def call(self, function: str, *arguments: Any) -> None:
        """Call a function of the page's scripts, with values that JSON has.

        This is the way for data that should not pass through elements: `frame.call("zbot.f", 1)`.
        """
        # JSON is JavaScript; a message's text stays a string in it.
        words = ",".join(json.dumps(one) for one in arguments)
        # At once, unlike Client.run_javascript: whether there is something to draw is asked below.
        code = {"code": f"{function}({words})"}
        self._client.outbox.enqueue_message("run_javascript", code, self._client.id)

    def _on_ask(self) -> None:
        if not self.is_awake:
            self._wake()
        outbox = self._client.outbox
        self.pace.run(time.monotonic())
        is_changed = bool(outbox.updates or outbox.messages)
        # NiceGUI sends changes first: the browser gets this when it has drawn them.
        self.call("zbot.answered", is_changed)

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

    def _wake(self) -> None:
        self.is_awake = True
        for watch in list(self.watches):
            cast("Watch", watch).resume()

    def _sleep(self) -> None:
        self.is_awake = False
        for watch, even_hidden in list(self.watches.items()):
            if not even_hidden:
                cast("Watch", watch).pause()
