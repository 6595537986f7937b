"""viser's server, which only the guard can reach."""

from __future__ import annotations

import contextlib
import io
from typing import TYPE_CHECKING, Any

from zbot.errors.installation import pip_install
from zbot.observer.errors import ViewerError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


def check_extra() -> None:
    """Check that the packages of the extra `view` are installed.

    Raises:
        ViewerError: One of the packages is not installed.
    """
    from importlib.util import find_spec  # noqa: PLC0415 - only here

    for name in ("viser", "trimesh", "PIL", "numpy"):
        if find_spec(name) is None:
            raise ViewerError(f"the view needs {name}: install it with {pip_install('zbot[view]')}")


@contextlib.contextmanager
def viser_server(is_own_port: Callable[[int], bool]) -> Iterator[Any]:
    """Run viser's server on a free port of this machine.

    Args:
        is_own_port: Function that returns whether a connection from this port is one of the guard.
            The server closes all others before it sends or reads a message.
    """
    import viser  # noqa: PLC0415 - an extra, and slow to import

    class _Server(viser.ViserServer):
        def request_share_url(self, verbose: bool = True) -> str | None:  # noqa: ARG002 - viser's arguments
            """Refuse: viser would open a tunnel through a server on the internet."""
            return None

    # viser prints its own address, which is not the address for the user.
    with contextlib.redirect_stdout(io.StringIO()):
        server = _Server("127.0.0.1", 0, verbose=False)
    _refuse_others(server, is_own_port)
    try:
        yield server
    finally:
        with contextlib.redirect_stdout(io.StringIO()):
            server.stop()


def _refuse_others(server: Any, is_own_port: Callable[[int], bool]) -> None:
    # viser has no public check of requests, and any website may open a websocket to 127.0.0.1.
    inner = server._websock_server  # noqa: SLF001 - the only place where a connection is known

    async def check(client: Any) -> None:
        connection = inner._live_connections[client.client_id]  # noqa: SLF001 - as above
        if not is_own_port(connection.remote_address[1]):
            await connection.close(1008, "only zbot's guard may connect")

    inner.on_client_connect(check)
