"""Names of a server in the header Host.

With DNS rebinding, the name of a website leads to 127.0.0.1. The header Host of its requests then
contains the website's name.
"""

from __future__ import annotations

import ipaddress
import re
import socket

_LOCAL_NAMES = frozenset({"localhost", "127.0.0.1", "::1"})
_HOST = re.compile(r"(?P<name>\[[0-9a-fA-F:.]+\]|[\w.-]+)(:\d+)?\Z")


class OwnNames:
    """Names and addresses that lead to a server.

    Args:
        host: The host that the server listens on.
        has_token: Whether browsers need a token. Then more names are accepted.
    """

    def __init__(self, host: str, *, has_token: bool) -> None:
        self._has_token = has_token
        self._names = _LOCAL_NAMES | {host.lower()}
        if has_token:
            # Any machine of the network can claim these names by mDNS, which is DNS rebinding. With
            # a token, this is harmless.
            self._names |= names_of_machine()

    def __contains__(self, host: str) -> bool:
        """Return whether a header Host, e.g. `localhost:8080`, has a name of the server."""
        match = _HOST.match(host)
        name = match["name"].strip("[]").lower() if match else ""
        # With a token, all IP addresses are accepted, because the machine may get a new address.
        return name in self._names or (self._has_token and _is_address(name))


def names_of_machine() -> set[str]:
    """Return the names of this machine in the network, in small letters."""
    name = socket.gethostname().lower()
    return {name, f"{name}.local", name.partition(".")[0]}


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
