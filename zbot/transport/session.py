"""Zenoh sessions, and the meeting point where the sessions of one domain find each other.

A node's session is a Zenoh peer on loopback. It connects to the domain's meeting port. The first
process on that port runs a small router, which introduces the peers to each other and serves the
clients of the command line. When that process ends, another process opens the port.
Only this module calls `zenoh.open()`.
"""

from __future__ import annotations

import os
import socket
import sys
import threading
import time
from pathlib import Path
from typing import Any

import zenoh

from zbot.transport import membership
from zbot.transport.config import MEETING_PORT, DiscoveryRange, SessionConfig, hub_port
from zbot.transport.errors import SessionError

LOOPBACK = "127.0.0.1"
_TAKEN_TIMEOUT_S = 0.1
_LINK_PAUSE_S = 0.005  # Zenoh lists a link a short time after it was opened
_FOUND_PAUSE_S = 0.25  # enough for all machines to answer multicast and then send their tokens
_OPEN_TIMEOUT_MS = 500
# Time that a put with `DROP` waits for space in the queue. The queue is soon full if a busy machine
# does not run the sending thread. With Zenoh's default of 1000 us, bursts lost 14 to 37 % of their
# messages beside six busy processes. With 20 ms, one burst was lost. DDS waits 100 ms by default
# too. A subscriber that stands still makes its publisher wait once, and not at each message.
_DROP_WAIT_US = 100_000
_NO_FILE = SessionConfig("the configuration between hubs", "{}")
_RETRY = {"period_init_ms": 20, "period_max_ms": 500, "period_increase_factor": 2}
# The router tries less often to connect to the hub, because most machines have no hub, and each try
# wakes an idle node three times.
_RETRY_HUB = _RETRY | {"period_max_ms": 2000}


def _open(what: str, config: zenoh.Config) -> zenoh.Session:
    if "RUST_LOG" in os.environ:
        zenoh.try_init_log_from_env()
    try:
        return zenoh.open(config)
    except zenoh.ZError as exc:
        raise SessionError(what, str(exc)) from exc


def process_facts(version: str) -> dict[str, Any]:
    """Return the facts about this process, for a session's admin space (see docs/wire.md)."""
    command = " ".join([Path(sys.argv[0]).name, *sys.argv[1:]]) if sys.argv else ""
    # Python represents bytes that are not UTF-8 by surrogates. Zenoh's JSON parser refuses them.
    command = command.encode(errors="replace").decode()
    return {
        "zbot": {
            "version": version,
            "host": socket.gethostname(),
            "pid": os.getpid(),
            "started": time.time_ns(),
            "command": command,
        }
    }


def _common(facts: dict[str, Any]) -> dict[str, Any]:
    return {
        "metadata": facts,
        "adminspace/enabled": True,
        "scouting/delay": 1,  # ms that Zenoh waits in open()
        "connect/timeout_ms": -1,
        "connect/exit_on_failure": False,
        "connect/retry": _RETRY,
        # close() waits this long for a program that accepts a link and never answers. Other
        # programs take 5 ms.
        "transport/unicast/open_timeout": _OPEN_TIMEOUT_MS,
        # Microseconds that a put may wait for a blocked reader before the reader's link is closed.
        "transport/link/tx/queue/congestion_control/block/wait_before_close": 60_000_000,
        # Only puts use shared memory. Zenoh takes 16 MB for a session's first message in shared
        # memory. Without this setting, admin space replies of twelve nodes used shared memory too,
        # and forty nodes took 700 MB.
        "transport/shared_memory/transport_optimization/messages": ["put"],
        **membership.session_settings(membership.load()),
    }


def open_hub(
    listen: list[str], connect: list[str], settings: dict[str, Any], facts: dict[str, Any]
) -> zenoh.Session:
    """Open the router session that links this machine with others.

    Args:
        listen: Zenoh endpoints that must be free.
        connect: Zenoh endpoints to connect to. The hub retries while they do not answer.
        settings: Zenoh's configuration paths and values for the hub, besides those of all sessions.
        facts: See `process_facts`.

    Raises:
        SessionError: An endpoint to listen on is in use, or a setting is not valid.
    """
    force = {
        "mode": "router",
        "listen/endpoints": listen,
        "listen/timeout_ms": 0,
        "listen/exit_on_failure": True,
        "connect/endpoints": connect,
        "scouting/multicast/enabled": False,
        **settings,
    }
    return _open("the hub", _NO_FILE.build(_common(facts), force))


def hub_endpoint() -> str:
    """Return the Zenoh endpoint on which a hub of this machine listens."""
    return f"tcp/{LOOPBACK}:{hub_port()}"


def open_hub_client(
    endpoint: str | None = None, more: dict[str, Any] | None = None
) -> zenoh.Session | None:
    """Open a client session of a hub.

    Args:
        endpoint: The hub's endpoint. If left out, this machine's hub is used.
        more: Zenoh's configuration paths and values, e.g. a user name other than this machine's.

    Returns:
        The session, or `None` if there is no hub or the hub refuses this machine.
    """
    settings = {
        "mode": "client",
        "connect/endpoints": [endpoint or hub_endpoint()],
        "connect/timeout_ms": 0,
        "connect/exit_on_failure": True,
        "scouting/multicast/enabled": False,
        **(more or {}),
    }
    try:
        return _open("a Zenoh session", _NO_FILE.build(_common({}), settings))
    except SessionError:
        return None


class MeetingPoint:
    """Meeting port of one domain on this machine, and the sessions that use it.

    Args:
        config: The configuration on which the configuration of every session is based.
        domain: 0 to 232.
        reach: With OFF, no port is opened and no other program is found.
        facts: See `process_facts`.
    """

    def __init__(
        self, config: SessionConfig, domain: int, reach: DiscoveryRange, facts: dict[str, Any]
    ) -> None:
        self._config = config
        self._reach = reach
        self._facts = facts
        self.port = MEETING_PORT + domain
        self.shares_memory = False  #: whether the peer may use shared memory for large messages
        self._router: zenoh.Session | None = None
        self._lock = threading.Lock()
        self._closed = False

    @property
    def endpoint(self) -> str:
        """The Zenoh endpoint of the meeting port."""
        return f"tcp/{LOOPBACK}:{self.port}"

    def _multicast(self) -> dict[str, Any]:
        return {
            "scouting/multicast/enabled": self.reaches_out,
            "scouting/multicast/autoconnect": {"router": ["router"], "peer": ["router", "peer"]},
        }

    def open_router(self) -> bool:
        """Open the router on the meeting port if no other process has the port.

        Returns:
            Whether this process has the router now.
        """
        if self._reach is DiscoveryRange.OFF:
            return False
        with self._lock:
            if self._closed or self._router is not None:
                return self._router is not None
            if self._is_taken():
                return False  # without this check, a failed try takes 5 ms and some megabytes
            listen = [self.endpoint]
            if self.reaches_out:
                listen.append("tcp/[::]:0")
            force = {
                "mode": "router",
                "listen/endpoints": listen,
                "listen/timeout_ms": 0,
                "listen/exit_on_failure": True,
                "connect/endpoints": [hub_endpoint()],
                "connect/retry": _RETRY_HUB,
                **self._multicast(),
            }
            try:
                self._router = _open(
                    "the meeting router", self._config.build(_common(self._facts), force)
                )
            except SessionError:
                return False  # another process has just taken the port
            return True

    def _is_taken(self) -> bool:
        # `create_connection` takes 3 ms more, because it imports the codec for international names.
        with socket.socket() as connection:
            connection.settimeout(_TAKEN_TIMEOUT_S)
            try:
                connection.connect((LOOPBACK, self.port))
            except TimeoutError:
                return True  # the process on the port is too busy to answer
            except OSError:
                return False
        return True

    @property
    def router(self) -> zenoh.Session | None:
        """The router session of the domain, if this process has it."""
        return self._router

    @property
    def reaches_out(self) -> bool:
        """Whether the domain's programs search for other machines by multicast."""
        return self._reach is DiscoveryRange.SUBNET

    def wait_for_routers(self, timeout_s: float) -> None:
        """Wait until this process's router has found the routers of other machines by multicast.

        The call ends 0.25 s after it found the last router, or when the time is over.
        """
        deadline, found = time.monotonic() + timeout_s, 0
        while self.reaches_out and self._router is not None and time.monotonic() < deadline:
            count = len(self._router.info.routers_zid())
            if count > found:
                found, deadline = count, time.monotonic() + _FOUND_PAUSE_S
            time.sleep(_LINK_PAUSE_S)

    def open_peer(self) -> zenoh.Session:
        """Open the session of a process with nodes.

        Raises:
            SessionError: Zenoh cannot open the session, usually because of the configuration file.
        """
        fill = {
            "mode": "peer",
            "listen/endpoints": ["tcp/[::]:0"] if self.reaches_out else [f"tcp/{LOOPBACK}:0"],
            "connect/endpoints": [self.endpoint],
            "transport/link/tx/queue/congestion_control/drop/wait_before_drop": _DROP_WAIT_US,
            **_common(self._facts),
            **self._multicast(),
        }
        if self._reach is DiscoveryRange.OFF:
            fill |= {"listen/endpoints": [], "connect/endpoints": []}
        built = self._config.build(fill)
        self.shares_memory = built.get_json("transport/shared_memory/enabled") == "true"
        return _open("a Zenoh session", built)

    def open_introducer(self) -> zenoh.Session:
        """Open a peer without a node. Peers link to it, and it introduces them to each other.

        Raises:
            SessionError: Zenoh cannot open the session.
        """
        force = {
            "mode": "peer",
            "listen/endpoints": [],
            "connect/endpoints": [self.endpoint],
            "scouting/multicast/enabled": False,
        }
        return _open("a Zenoh session", self._config.build(_common({}), force))

    def open_client(self) -> zenoh.Session | None:
        """Open a client session of the domain's router. Without a router, use this machine's hub.

        Returns:
            The session, or `None` if there is neither router nor hub.
        """
        if self._reach is DiscoveryRange.OFF:
            return None
        fill = {
            "mode": "client",
            # If this machine has no router, the hub still knows the nodes of other machines.
            "connect/endpoints": [self.endpoint, hub_endpoint()],
            **_common(self._facts),
            "connect/timeout_ms": 0,
            "connect/exit_on_failure": True,
            "scouting/multicast/enabled": False,
        }
        try:
            return _open("a Zenoh session", self._config.build(fill))
        except SessionError:
            return None

    def close(self) -> None:
        """Close this process's router, if any, and never open it again. May be called twice."""
        with self._lock:
            self._closed = True
            if self._router is not None:
                self._router.close()
                self._router = None
