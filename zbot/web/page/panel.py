"""Panel of the page, and the objects `Page` and `Section` that a panel uses."""

from __future__ import annotations

import json
import time
import traceback
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, TypeVar, cast

from nicegui import ui

from zbot.classroom.hub.address import own_addresses
from zbot.log import get_logger
from zbot.observer.serving.address import is_loopback
from zbot.observer.transforms import TransformWatch
from zbot.web.page.update_scheduler import UpdateScheduler

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from nicegui import Client

    from zbot.observer.system import System
    from zbot.observer.watch import Watch
    from zbot.web.page.layout import Layout


@dataclass(frozen=True, slots=True)
class Panel:
    """One view of the live page, with its own path."""

    path: str  #: `/topics`
    title: str
    icon: str  #: name of a Material icon, e.g. `hub`
    build: Callable[[Page], None]  #: adds the elements; called once for each browser


@dataclass(frozen=True, slots=True)
class PageServer:
    """Server of the page, as far as panels need it."""

    host: str  #: the host that the server listens on
    port: int
    panels: Sequence[Panel] = ()  #: all panels
    layout: Layout | None = None  #: the layout that the server was started with
    scheme: str = "http"  #: `http` or `https`
    token: str | None = None  #: the token that other machines need


class Releasable(Protocol):
    """Watch or reference that must be released."""

    def release(self) -> None:
        """Release it. A second call does nothing."""


ReleasableT = TypeVar("ReleasableT", bound=Releasable)


class Section:
    """Section of a page, such as the details of a topic. It can be closed before the page.

    Its methods must be called in NiceGUI's loop.

    Args:
        page: The page.
        forget: Called at the end of an inner section.
    """

    def __init__(self, page: Page, forget: Callable[[], object] | None = None) -> None:
        self.page = page
        self._forget = forget
        self._endings: dict[object, Callable[[], object]] = {}
        self._is_closed = False

    @property
    def system(self) -> System:
        """The running system."""
        return self.page.system

    def live(self, update: Callable[[], None], max_hz: float = 30.0) -> Callable[[], None]:
        """Call a function when the browser is about to draw, at most `max_hz` times a second.

        The function runs in NiceGUI's loop and changes elements. It must be quick. If `Watch.count`
        and `System.revision` are unchanged, the function should not change elements, so that the
        browser asks less often. If the function raises an error, the page shows the error and does
        not call the function again.

        Returns:
            A function that ends the calls. A second call of this function does nothing.
        """
        undo = self.page.scheduler.add(update, max_hz)
        return self.on_close(undo)

    def watch(
        self, topic: str, type_name: str | None = None, *, keep: int = 0, even_hidden: bool = False
    ) -> Watch:
        """Watch a topic while the page is visible. The end of the section releases the watch.

        Args:
            topic: Full name.
            type_name: Full name of its type. None means the type in the graph.
            keep: The number of messages to keep for `Watch.since`.
            even_hidden: Whether to receive messages also while the page is hidden.
        """
        is_awake = self.page.is_awake
        watch = self.system.watch(topic, type_name, keep=keep, is_active=is_awake)
        self.page.watches[watch] = even_hidden
        return self.keep(watch)

    def watch_transforms(self) -> TransformWatch:
        """Watch all transforms while the page is visible."""
        watch = TransformWatch(self.system, is_active=self.page.is_awake)
        self.page.watches[watch] = False
        return self.keep(watch)

    def keep(self, thing: ReleasableT) -> ReleasableT:
        """Return a watch or a reference, and release it when the section is closed.

        A section that is closed already releases it now.
        """
        self._endings[thing] = thing.release
        if self._is_closed:
            self.close()
        return thing

    def drop(self, thing: Releasable) -> None:
        """Release a watch or a reference now. A second call does nothing."""
        self._endings.pop(thing, None)
        self.page.watches.pop(thing, None)
        thing.release()

    def on_close(self, callback: Callable[[], object]) -> Callable[[], None]:
        """Call a function when the section is closed.

        Returns:
            A function that calls the callback immediately instead of at the close. A second call
            of this function does nothing.
        """
        key = object()
        self._endings[key] = callback

        def end() -> None:
            ending = self._endings.pop(key, None)
            if ending is not None:
                ending()

        return end

    def section(self) -> Section:
        """Return an inner section. Its own `close` closes it, or the end of this section."""
        section = Section(self.page, lambda: self._endings.pop(section, None))
        self._endings[section] = section.close
        return section

    def close(self) -> None:
        """Release all watches and references, and end all calls. A second call does nothing."""
        self._is_closed = True
        if self._forget is not None:
            self._forget()
        while self._endings:
            thing, end = self._endings.popitem()
            self.page.watches.pop(thing, None)
            end()


class Page(Section):
    """Page of one browser, which shows one panel.

    The browser asks for changes when it is about to draw, and asks again after it has drawn them.
    The server sends changes only then, so no data waits for a hidden, slow or disconnected browser.
    The page is closed when the user closes or reloads it, or when its browser stays disconnected.

    Args:
        client: NiceGUI's object for the browser.
        system: The running system.
        query: The parameters of the address, after the `?`.
        server: The server of the page.

    Attributes:
        query: The parameters of the address, e.g. `{"topic": "/scan"}`.
        toolbar: A row beside the title, for buttons and filters: `with page.toolbar: ...`
        command: The `zbot ...` command that the page shows below the panel.
        is_awake: Whether the page is visible and connected.
    """

    toolbar: ui.element

    def __init__(
        self, client: Client, system: System, query: Mapping[str, str], server: PageServer
    ) -> None:
        super().__init__(self)
        self.server = server
        self._system = system
        self.query = dict(query)
        self.command = ""
        self.is_awake = False
        self.scheduler = UpdateScheduler(self._on_fault)
        self.watches: dict[object, bool] = {}  #: each watch and its `even_hidden`
        self._client = client
        self._choosers: dict[str, Callable[[str], None]] = {}
        self._show: Callable[[str], object] | None = None
        ui.on("zbot_ask", self._on_ask)
        ui.on("zbot_sleep", self._sleep)
        ui.on("zbot_choose", self._chose)
        client.on_disconnect(self._sleep)
        client.on_delete(self.close)

    @property
    def system(self) -> System:
        """The running system."""
        return self._system

    @property
    def read_only(self) -> bool:
        """Whether the page can only show the system and not change it."""
        return self.system.read_only

    @property
    def is_local(self) -> bool:
        """Whether the browser runs on this machine."""
        return is_loopback(self._client.ip) or self._client.ip in own_addresses()

    @property
    def host_name(self) -> str:
        """The name or the IP address of the server, as the browser knows it."""
        return self._client.request.url.hostname or self.server.host

    @property
    def user_agent(self) -> str:
        """The text with which the browser describes itself."""
        return self._client.request.headers.get("user-agent", "")

    def show_command(self, command: str) -> None:
        """Show the `zbot ...` command that does the same as the user's last click."""
        self.command = command
        if self._show is not None:
            self._show(command)

    def on_command(self, show: Callable[[str], object]) -> None:
        """Set the function that shows commands below the panel."""
        self._show = show
        show(self.command)

    def on_choose(self, element_id: str, choose: Callable[[str], None]) -> None:
        """Call a function with the key of the row that the user clicks in a table. See `Table`."""
        self._choosers[element_id] = choose

    def _chose(self, event: Any) -> None:
        element_id, key = event.args
        if element_id in self._choosers:
            self._choosers[element_id](str(key))

    def set_query(self, /, **query: str) -> None:
        """Set the parameters of the address, so that the page shows the same after a reload."""
        self.query = query
        self.call("zbot.setQuery", query)

    def call(self, function: str, *arguments: Any) -> None:
        """Call a function of the page's scripts with JSON values, e.g. `page.call("zbot.f", 1)`.

        Use this method for data that does not belong to an element of NiceGUI.
        """
        # JSON is valid JavaScript. So a string in a message stays a string and cannot run as code.
        words = ",".join(json.dumps(argument) for argument in arguments)
        # Client.run_javascript would enqueue the code later, after `_on_ask` has read the outbox.
        code = {"code": f"{function}({words})"}
        self._client.outbox.enqueue_message("run_javascript", code, self._client.id)

    def _on_ask(self) -> None:
        if not self.is_awake:
            self._wake()
        outbox = self._client.outbox
        self.scheduler.run(time.monotonic())
        is_changed = bool(outbox.updates or outbox.messages)
        # NiceGUI sends changes first, so this call runs after the browser has drawn them.
        self.call("zbot.answered", is_changed)

    def _on_fault(self, error: Exception) -> None:
        trace = "".join(traceback.format_exception(error))
        get_logger("zbot.web").error(f"a part of the page stopped\n{trace}")
        with self._client:
            ui.notify(
                f"This section of the page has stopped: {error}",
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
