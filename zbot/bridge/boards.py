"""Router for microcontrollers, and the bridge that shows them in zbot's domain, in one process."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from typing import TYPE_CHECKING

from zbot.bridge.bridge import BridgeOptions, run_rmw_zenoh
from zbot.transport.config import HUB_PORT, hub_port, port_of
from zbot.transport.errors import TransportError
from zbot.transport.rmw_meeting import RmwRouter

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

# In a class, the hub of this machine has the first port.
_PORTS = 4
_EVERYWHERE = "0.0.0.0"  # all interfaces of this machine  # noqa: S104 - boards are elsewhere


def run_boards(options: BridgeOptions, listen: list[str], on_ready: Callable[[int], None]) -> None:
    """Let boards with zenoh-pico connect, and link them with this domain, until Ctrl-C or SIGTERM.

    Args:
        options: What the bridge carries. `connect` and `on_ready` are replaced.
        listen: Zenoh endpoints to listen on. If empty, it is the first free port of four, from the
            port of this machine's hub on (7447), on all interfaces.
        on_ready: Called when boards can connect, with the port.

    Raises:
        TransportError: The endpoints are in use.
        SettingError: A configuration file or the override variable is not valid.
    """
    session, endpoint = _open_router(listen)
    here = endpoint.replace("[::]", "localhost").replace(_EVERYWHERE, "localhost")
    with closing(session):
        port = int(port_of(endpoint))
        run_rmw_zenoh(replace(options, connect=here, on_ready=lambda: on_ready(port)))


def _open_router(listen: list[str]) -> tuple[zenoh.Session, str]:
    """Return the session of the router, and the endpoint on which it listens."""
    first = hub_port()
    usual = [[f"tcp/{_EVERYWHERE}:{first + number}"] for number in range(_PORTS)]
    if first == HUB_PORT:
        usual[0] = []  # the endpoints of the configuration file, or else this port
    choices = [listen] if listen else usual
    for choice in choices[:-1]:
        try:
            return _opened(choice)
        except TransportError:
            continue  # another program has the port
    return _opened(choices[-1])


def _opened(listen: list[str]) -> tuple[zenoh.Session, str]:
    router = RmwRouter(listen, [])
    return router.open(), router.listen[0]
