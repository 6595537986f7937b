"""Server for Foxglove and Lichtblick, which shows the topics and nodes of a domain live."""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import traceback
from typing import TYPE_CHECKING, Any
from urllib.parse import urlencode

from zbot.errors import ZbotError
from zbot.errors.installation import pip_install
from zbot.log import get_logger
from zbot.names import is_hidden
from zbot.observer.errors import ViewerError
from zbot.observer.serving.address import address, is_loopback, origin_of
from zbot.observer.serving.until_signal import serve_until_signal
from zbot.observer.system import System
from zbot.process.serving import serving
from zbot.threads.background_thread import background_thread
from zbot.web.foxglove.channels import Channels
from zbot.web.foxglove.guard import FOXGLOVE_ORIGIN, Guard, free_loopback_address
from zbot.web.foxglove.listener import Listener
from zbot.web.foxglove.parameters import Parameters
from zbot.web.foxglove.publishing import Publishing
from zbot.web.foxglove.services import Services
from zbot.web.foxglove.type_search import TypeSearch
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from threading import Event

    from zbot.graph.snapshot import Snapshot

_LOOK_S = 0.3
_TRIED_PORTS = 20


def no_port_error(host: str, port: int, reason: str) -> ViewerError:
    """Return the error that the server cannot listen."""
    return ViewerError(f"cannot listen on {host}, port {port}: {reason}")


def check_extra() -> None:
    """Raise `ViewerError` if the package `foxglove-sdk` is not installed."""
    try:
        import foxglove  # noqa: F401, PLC0415 - an extra
    except ImportError:
        text = f"Foxglove needs foxglove-sdk: {pip_install('zbot[foxglove]')}"
        raise ViewerError(text) from None


def serve(
    host: str,
    port: int,
    *,
    read_only: bool,
    origins: Sequence[str],
    on_ready: Callable[[str, str], None],
) -> None:
    """Serve until Ctrl-C.

    Args:
        host: The address to listen on. If it is not a loopback address, clients need a token.
        port: The port. If it is taken, the next free port is used. 0 means any free port.
        read_only: Whether clients can only read.
        origins: Addresses of further web applications that may connect.
        on_ready: Called with the address of the websocket and the address of the web application.

    Raises:
        ViewerError: The package `foxglove-sdk` is not installed, or the server cannot listen, or an
            origin is not the address of a page.
    """
    check_extra()
    allowed = [origin_of(origin) for origin in origins]
    with serving(), System(read_only=read_only) as system, _sdk_server(system) as inner:
        token = None if is_loopback(host) else secrets.token_urlsafe(16)
        guard = Guard(host, inner, token, allowed, publishing=lambda: Publishing(system))

        def ready(own_port: int) -> None:
            websocket = address(host, own_port, "/", token, scheme="ws")
            query = urlencode({"ds": "foxglove-websocket", "ds.url": websocket})
            on_ready(websocket, f"{FOXGLOVE_ORIGIN}/~/view?{query}")

        try:
            asyncio.run(_listen(guard, host, port, ready))
        finally:
            guard.close()


@contextlib.contextmanager
def _sdk_server(system: System) -> Iterator[tuple[str, int]]:
    """Run the SDK's server behind the guard. Yield the host and the port of the SDK's server."""
    import foxglove  # noqa: PLC0415 - an extra
    from foxglove.websocket import Capability  # noqa: PLC0415 - as above

    foxglove.set_log_level("CRITICAL")  # the SDK would report each client that closes its window
    context = foxglove.Context()
    types = TypeSearch(system.interface)
    channels, parameters = Channels(system, context, types), Parameters(system)
    capabilities = [Capability.ConnectionGraph, Capability.Parameters]
    if not system.read_only:
        capabilities += [Capability.ClientPublish, Capability.Services]
    host = free_loopback_address()
    server = foxglove.start_server(
        name=f"zbot, domain {system.domain_id}",
        host=host,
        port=0,
        capabilities=capabilities,
        server_listener=Listener(system, channels, parameters),
        supported_encodings=["cdr", "json"],
        context=context,
    )
    services = None if system.read_only else Services(system, server, types)

    def follow(is_over: Event) -> None:
        seen = -1
        while not is_over.is_set():
            if system.revision != seen or types.is_due:
                seen = system.revision
                try:
                    graph = system.snapshot()
                    types.forget_unused({end.type_name for end in graph.endpoints})
                    channels.update(graph)
                    if services is not None:
                        services.update(graph)
                    server.publish_connection_graph(_connection_graph(graph))
                except Exception as error:  # noqa: BLE001 - the next change is shown again
                    lines = traceback.format_exception(error)
                    text = str(error) if isinstance(error, ZbotError) else "".join(lines)
                    get_logger("zbot.foxglove").error(text)
            is_over.wait(_LOOK_S)

    try:
        with background_thread("zbot foxglove", follow):
            yield host, server.port
    finally:
        server.stop()


async def _listen(guard: Guard, host: str, port: int, ready: Callable[[int], None]) -> None:
    server = await _started(guard, host, port)
    own_port = server.sockets[0].getsockname()[1]
    await serve_until_signal(server, lambda: ready(own_port))


async def _started(guard: Guard, host: str, port: int) -> asyncio.Server:
    last = port + _TRIED_PORTS if port else port
    while True:
        try:
            return await asyncio.start_server(guard.serve, host, port)
        except OSError as error:
            if port >= last:
                raise no_port_error(host, port, error.strerror or str(error)) from error
            port += 1


def _connection_graph(graph: Snapshot) -> Any:
    from foxglove import ConnectionGraph  # noqa: PLC0415 - an extra

    made = ConnectionGraph()
    for name, _ in graph.topics():
        if not is_hidden(name):
            made.set_published_topic(name, _nodes(graph.publishers(name)))
            made.set_subscribed_topic(name, _nodes(graph.subscriptions(name)))
    for name, _ in graph.services():
        providers = _nodes(graph.on(name, EntityKind.SERVICE))
        if providers and not is_hidden(name):
            made.set_advertised_service(name, providers)
    return made


def _nodes(ends: Sequence[Any]) -> list[str]:
    names = {end.full_node_name for end in ends if not is_hidden(end.node)}
    return sorted(names)
