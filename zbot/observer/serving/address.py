"""Addresses of the page."""

from __future__ import annotations

import ipaddress
from urllib.parse import parse_qsl, urlencode, urlsplit

from zbot.observer.errors import ViewerError

#: Parameter of the query that contains the token.
TOKEN_PARAMETER = "token"  # noqa: S105 - a name, not a token
#: Hosts that mean all addresses of this machine.
ANY_HOSTS = frozenset({"0.0.0.0", "::"})  # noqa: S104 - they are compared, not bound
#: Paths of the websockets for rosbridge. Programs for ROS 2's rosbridge_server use `/`.
ROSBRIDGE_PATHS = ("/", "/rosbridge")


def origin_error(text: str) -> ViewerError:
    """Return the error that a text is not the address of a page that a web server serves."""
    return ViewerError(
        f"{text!r} is not the address of a page on a web server, e.g. http://localhost:8000"
    )


def is_loopback(host: str) -> bool:
    """Return whether only this machine can reach a host name or address."""
    if host.lower() == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def other_machine(host: str) -> str:
    """Return the address of a client on another machine, or an empty text for this machine."""
    return "" if not host or is_loopback(host) else host


def address(host: str, port: int, path: str, token: str | None, *, scheme: str = "http") -> str:
    """Return the address for the user's browser, or with the scheme `ws` for a web program."""
    name = f"[{host}]" if ":" in host else host
    query = f"?{urlencode({TOKEN_PARAMETER: token})}" if token else ""
    return f"{scheme}://{name}:{port}{path}{query}"


def without_token(target: str) -> str:
    """Return the path and the query of an address, without the token."""
    path, _, query = target.partition("?")
    pairs = [pair for pair in parse_qsl(query) if pair[0] != TOKEN_PARAMETER]
    return path + (f"?{urlencode(pairs)}" if pairs else "")


def origin_of(address: str) -> str:
    """Return the origin in an address of a page, e.g. `http://localhost:8000`.

    Raises:
        ViewerError: The text is not an address of a page on a web server.
    """
    try:
        parts = urlsplit(address)
        port = parts.port
    except ValueError:
        raise origin_error(address) from None
    if parts.scheme not in {"http", "https"} or not parts.hostname or parts.username is not None:
        raise origin_error(address)
    # In an origin, browsers leave out the default port of the scheme.
    is_usual = port in {None, {"http": 80, "https": 443}[parts.scheme]}
    name = f"[{parts.hostname}]" if ":" in parts.hostname else parts.hostname
    return f"{parts.scheme}://{name}" if is_usual else f"{parts.scheme}://{name}:{port}"
