"""Server of the view. `serve()` runs it until Ctrl-C."""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.observer.serving.address import is_loopback
from zbot.observer.serving.browser import open_page
from zbot.observer.serving.port import DEFAULT_HOST, addresses_of, listen
from zbot.observer.serving.until_signal import serve_until_signal
from zbot.observer.system import System
from zbot.threads.background_thread import background_thread
from zbot.view.server.guard import Guard
from zbot.view.server.viser_server import check_extra, viser_server

if TYPE_CHECKING:
    import socket
    from collections.abc import Callable, Iterator

    from zbot.node.node import Node
    from zbot.view.arrangement.arrangement import Arrangement
    from zbot.view.frames import Frames
    from zbot.view.source import Source
    from zbot.view.view import View

DEFAULT_PORT = 8090
#: Bytes a second for browsers on other machines.
OVER_NETWORK = 200_000.0


@dataclass(frozen=True)
class Content:
    """What a view shows at first.

    Attributes:
        robot: A file with a robot description, which is shown with its joints at 0.
        bag: A bag, which is shown in place of the domain.
        arrangement: The displays, in place of the usual ones.
        node: A node in whose namespace, with whose rules and at whose time the view works, or None
            for the view's own. The caller spins it.
        bytes_per_s: How much the view may send to each browser, or None for no limit.
        read_only: Whether the view can only show the system, so that its tools do not publish.
    """

    robot: Path | None = None
    bag: Path | None = None
    arrangement: Arrangement | None = None
    node: Node | None = None
    bytes_per_s: float | None = None
    read_only: bool = False


def bytes_per_s(host: str, kilobytes_per_s: float | None) -> float | None:
    """Return how many bytes a second a view on a host may send, or None for no limit.

    Args:
        host: The host that the view listens on.
        kilobytes_per_s: The choice of the user. 0 means no limit. None means no limit for this
            machine, and 200 kB/s for other machines.
    """
    if kilobytes_per_s is None:
        return None if is_loopback(host) else OVER_NETWORK
    return kilobytes_per_s * 1000 or None


def _print(line: str) -> None:
    print(line, flush=True)


def _print_error(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def serve(
    host: str = DEFAULT_HOST,
    port: int = DEFAULT_PORT,
    *,
    open_browser: bool = False,
    content: Content | None = None,
    page_port: int | None = None,
    tell: Callable[[str], object] = _print,
    warn: Callable[[str], object] = _print_error,
) -> None:
    """Serve the view of this process's domain until a signal ends the server.

    Args:
        host: The host to listen on. Only this machine can reach a loopback address.
        port: The port. If it is taken, the server uses the next free port. 0 means any free port.
        open_browser: Whether to open the view in the user's browser.
        content: What is shown, if not the usual displays of the domain.
        page_port: The port of the live page that shows the view in a frame. Browsers then need a
            token also on this machine.
        tell: Called with a line for each address of the view.
        warn: Called with a sentence about what the view does not have, if there is such a thing.

    Raises:
        ViewerError: The extra is not installed, or the server cannot listen on this host and port.
        DescriptionError: The file is not a robot description.
        SessionError: Zenoh cannot open a session.
    """
    check_extra()
    listener = listen(host, port)
    token = None if is_loopback(host) and page_port is None else secrets.token_urlsafe(16)
    with contextlib.closing(listener):
        own_port = listener.getsockname()[1]
        addresses = addresses_of(host, own_port, "/", token)

        def ready() -> None:
            for address in addresses:
                tell(f"zbot view: {address}")
            if open_browser:
                open_page(addresses[0])

        guard = Guard(host, own_port, token, page_port)
        with _view(guard, content or Content(), addresses[0], warn) as inner:
            guard.inner = inner
            asyncio.run(_listen(guard, listener, ready))


@contextlib.contextmanager
def _view(
    guard: Guard, content: Content, address: str, warn: Callable[[str], object]
) -> Iterator[tuple[str, int]]:
    """Run the view behind the guard. Yield the host and the port of viser's server."""
    make = _domain_view if content.bag is None else _bag_view
    with viser_server(guard.is_own_port) as server, make(server, content, address) as view:
        guard.open_link, guard.rviz_file = view.open_link, view.rviz_file
        if content.arrangement is not None:
            sentence = view.open(content.arrangement)
            if sentence:
                warn(f"zbot view: {sentence}")
        if content.robot is not None:
            view.show_file(content.robot)
        with background_thread("zbot view", view.run):
            yield "127.0.0.1", server.get_port()


@contextlib.contextmanager
def _domain_view(server: Any, content: Content, address: str) -> Iterator[View]:
    """Make the view of this process's domain."""
    from zbot.tf2.diagnosis import TransformMonitor  # noqa: PLC0415 - imports numpy
    from zbot.view.clock import ViewClock  # noqa: PLC0415 - as above
    from zbot.view.frames import Frames  # noqa: PLC0415 - as above
    from zbot.view.tools.sender import Sender  # noqa: PLC0415 - as above
    from zbot.view.view import own_name  # noqa: PLC0415 - as above

    with System(read_only=content.read_only) as system:
        frames, node = Frames(), content.node or system.node
        frames.diagnosis = TransformMonitor(node, frames).diagnosis
        yield _made(
            server,
            f"zbot, domain {system.domain_id}",
            content,
            system,
            frames,
            resolve=own_name if content.node is None else content.node.resolve_topic_name,
            clock=ViewClock(node, is_automatic=content.node is None),
            outlet=Sender(system),
            address=address,
        )


@contextlib.contextmanager
def _bag_view(server: Any, content: Content, address: str) -> Iterator[View]:
    """Make the view of a bag, without a domain."""
    from zbot.bag.reader import Reader  # noqa: PLC0415 - few views need it
    from zbot.view.bag_source import BagSource, NoOutlet  # noqa: PLC0415 - as above
    from zbot.view.frames import Frames  # noqa: PLC0415 - as above

    frames, path = Frames(), str(content.bag)
    with BagSource(Reader(path), frames) as source:
        title = f"zbot, {Path(path).name}"
        yield _made(
            server,
            title,
            content,
            source,
            frames,
            clock=source,
            outlet=NoOutlet(),
            timeline=source,
            address=address,
        )


def _made(
    server: Any, title: str, content: Content, source: Source, frames: Frames, **options: Any
) -> View:
    from zbot.view.budget import Budget  # noqa: PLC0415 - imports numpy
    from zbot.view.drawing import Drawing  # noqa: PLC0415 - as above
    from zbot.view.panel import Panel  # noqa: PLC0415 - as above
    from zbot.view.view import View  # noqa: PLC0415 - as above

    budget = Budget(content.bytes_per_s)
    drawing = Drawing(server, is_thrifty=budget.total is not None)
    return View(
        source,
        frames,
        drawing,
        lambda ask: Panel(server.gui, title, ask),
        budget=budget,
        **options,
    )


async def _listen(guard: Guard, listener: socket.socket, ready: Callable[[], None]) -> None:
    await serve_until_signal(await asyncio.start_server(guard.serve, sock=listener), ready)
