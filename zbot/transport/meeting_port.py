"""TCP port on which the programs of a domain meet, and ports that the system keeps for itself.

Windows reserves ranges of ports for Hyper-V, WSL and Docker. On Linux, a normal user cannot use the
ports below `ip_unprivileged_port_start`. No program can listen on such a port, and only an attempt
to bind it shows this. All programs of a machine make the same attempts in the same order, so they
agree on a port without a file.
"""

from __future__ import annotations

import os
import socket

from zbot.transport.config import MEETING_PORT

LOOPBACK = "127.0.0.1"
#: Domain n uses the first of these numbers + n that the system does not reserve.
FIRST_PORTS = (MEETING_PORT, 17450, 27450)
_TAKEN_TIMEOUT_S = 0.1


def meeting_port(domain: int) -> int:
    """Return the port on which the programs of a domain meet on this machine.

    If the system reserves all ports of the domain, return the first one.
    """
    ports = [first + domain for first in FIRST_PORTS]
    return next((port for port in ports if not is_reserved(port)), ports[0])


def is_reserved(port: int) -> bool:
    """Return whether the system does not let this process listen on a port of 127.0.0.1."""
    with socket.socket() as probe:
        if os.name != "nt":  # so that the probe does not keep a router from the port
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((LOOPBACK, port))
        except PermissionError:
            # Windows also says so for a port that another program does not share.
            return not is_taken(port)
        except OSError:  # another program has the port
            return False
    return False


def is_taken(port: int) -> bool:
    """Return whether a program listens on a port of 127.0.0.1."""
    # `create_connection` takes 3 ms more, because it imports the codec for international names.
    with socket.socket() as connection:
        connection.settimeout(_TAKEN_TIMEOUT_S)
        try:
            connection.connect((LOOPBACK, port))
        except TimeoutError:
            # The process on the port is too busy to answer. But Windows takes two seconds to refuse
            # a connection, and accepts one for a busy process at once.
            return os.name != "nt"
        except OSError:
            return False
    return True
