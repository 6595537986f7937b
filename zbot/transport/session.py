"""Zenoh sessions, and the meeting point through which those of one domain find each other.

Every node's session is a Zenoh peer on loopback. It connects to the domain's meeting port, where a
small router lives inside whichever process got the port first; that router introduces the peers to
each other and serves the command line's clients. When its process ends, another takes the port.
This module is the only place that calls `zenoh.open()`.
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
_LINK_PAUSE_S = 0.005  # links are listed a moment after they came
_FOUND_PAUSE_S = 0.25  # machines answer multicast at about the same time, then tell their tokens
_OPEN_TIMEOUT_MS = 500
# How long `DROP` waits for room. Small batches are soon full where a busy machine does not let the
# sending thread run: of bursts of 300 messages of 3 kB beside six busy processes 14 to 37 % were
# lost with Zenoh's own 1000 us, none with these beside ten.
_BURST_US = 20_000
_NO_FILE = SessionConfig("the configuration between hubs", "{}")
_RETRY = {"period_init_ms": 20, "period_max_ms": 500, "period_increase_factor": 2}
# Most machines never have a hub: each try wakes an idle node three times.
_RETRY_HUB = _RETRY | {"period_max_ms": 2000}


def _open(what: str, config: zenoh.Config) -> zenoh.Session:
    if "RUST_LOG" in os.environ:
        zenoh.try_init_log_from_env()
    try:
        return zenoh.open(config)
    except zenoh.ZError as exc:
        raise SessionError(what, str(exc)) from exc


def process_facts(version: str) -> dict[str, Any]:
    """Return what a session tells of its process in the admin space (docs/wire.md)."""
    command = " ".join([Path(sys.argv[0]).name, *sys.argv[1:]]) if sys.argv else ""
    # Python hides bytes that are no UTF-8 in surrogates, which Zenoh's JSON refuses.
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
        "scouting/delay": 1,  # ms; Zenoh waits this long in open()
        "connect/timeout_ms": -1,
        "connect/exit_on_failure": False,
        "connect/retry": _RETRY,
        # close() waits as long for a partner that accepts and never answers; others take 5 ms.
        "transport/unicast/open_timeout": _OPEN_TIMEOUT_MS,
        # A blocked reader may stop the world for this long before its link is given up
        # (microseconds).
        "transport/link/tx/queue/congestion_control/block/wait_before_close": 60_000_000,
        # Zenoh takes 16 MB of memory for a session's first message that is shared. Answers from the
        # admin space are large enough where twelve nodes are: forty of them took 700 MB.
        "transport/shared_memory/transport_optimization/messages": ["put"],
        **membership.session_settings(membership.load()),
    }


def open_hub(
    listen: list[str], connect: list[str], settings: dict[str, Any], facts: dict[str, Any]
) -> zenoh.Session:
    """Open the router session that links this machine with others.

    Args:
        listen: Zenoh endpoints that must be free.
        connect: Those that are dialled, again and again while they do not answer.
        settings: Zenoh's configuration paths and values beyond those that every session has.
        facts: See `process_facts`.

    Raises:
        SessionError: An endpoint to listen on is taken, or a setting makes no sense.
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
    """Return where this machine's hub listens, if it has one."""
    return f"tcp/{LOOPBACK}:{hub_port()}"


def open_hub_client(
    endpoint: str | None = None, more: dict[str, Any] | None = None
) -> zenoh.Session | None:
    """Open a session that sees what a hub sees.

    Args:
        endpoint: The hub's; this machine's if left out.
        more: Zenoh's configuration paths and values, such as another user than this machine's.

    Returns:
        `None` if there is none, or it does not let this machine in.
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
    """One domain's meeting port on this machine: the way in, and the duty to keep it open.

    Args:
        config: The configuration that every session starts from.
        domain: 0 to 232.
        reach: OFF opens no port and looks for nobody.
        facts: See `process_facts`.
    """

    def __init__(
        self, config: SessionConfig, domain: int, reach: DiscoveryRange, facts: dict[str, Any]
    ) -> None:
        self._config = config
        self._reach = reach
        self._facts = facts
        self.port = MEETING_PORT + domain
        self.shares_memory = False  #: whether the peer's large messages may go that way
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

    def hold(self) -> bool:
        """Open the router behind the port if nobody has; the bind decides who wins.

        Returns:
            Whether this process holds the port now.
        """
        if self._reach is DiscoveryRange.OFF:
            return False
        with self._lock:
            if self._closed or self._router is not None:
                return self._router is not None
            if self._is_taken():
                return False  # which an attempt would tell, too, for some megabytes and 5 ms
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
                return False  # taken just now: by another process of the domain, or by a stranger
            return True

    def _is_taken(self) -> bool:
        # `create_connection` loads what spells the names of foreign hosts, for 3 ms.
        with socket.socket() as knock:
            knock.settimeout(_TAKEN_TIMEOUT_S)
            try:
                knock.connect((LOOPBACK, self.port))
            except TimeoutError:
                return True  # its holder is too busy to answer
            except OSError:
                return False
        return True

    @property
    def router(self) -> zenoh.Session | None:
        """The session that the domain's others meet at, if this process holds the port."""
        return self._router

    @property
    def reaches_out(self) -> bool:
        """Whether others are looked for on the network too."""
        return self._reach is DiscoveryRange.SUBNET

    def wait_found(self, timeout_s: float) -> None:
        """Wait until our router, if it reaches out, has found those of other machines.

        Returns a moment after the last one was found, or when the time is over.
        """
        deadline, found = time.monotonic() + timeout_s, 0
        while self.reaches_out and self._router is not None and time.monotonic() < deadline:
            count = len(self._router.info.routers_zid())
            if count > found:
                found, deadline = count, time.monotonic() + _FOUND_PAUSE_S
            time.sleep(_LINK_PAUSE_S)

    def open_peer(self) -> zenoh.Session:
        """Open a node process's session.

        Raises:
            SessionError: Zenoh refused, usually because of the configuration file.
        """
        fill = {
            "mode": "peer",
            "listen/endpoints": ["tcp/[::]:0"] if self.reaches_out else [f"tcp/{LOOPBACK}:0"],
            "connect/endpoints": [self.endpoint],
            "transport/link/tx/queue/congestion_control/drop/wait_before_drop": _BURST_US,
            **_common(self._facts),
            **self._multicast(),
        }
        if self._reach is DiscoveryRange.OFF:
            fill |= {"listen/endpoints": [], "connect/endpoints": []}
        built = self._config.build(fill)
        self.shares_memory = built.get_json("transport/shared_memory/enabled") == "true"
        return _open("a Zenoh session", built)

    def open_introducer(self) -> zenoh.Session:
        """Open a peer without a node: whoever it is linked to hears from it of the others.

        Raises:
            SessionError: Zenoh refused.
        """
        force = {
            "mode": "peer",
            "listen/endpoints": [],
            "connect/endpoints": [self.endpoint],
            "scouting/multicast/enabled": False,
        }
        return _open("a Zenoh session", self._config.build(_common({}), force))

    def open_client(self) -> zenoh.Session | None:
        """Open a session that sees the domain through its router, else through the machine's hub.

        Returns:
            `None` if nobody is there.
        """
        if self._reach is DiscoveryRange.OFF:
            return None
        fill = {
            "mode": "client",
            # The hub knows the nodes of other machines where there are none here.
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
        """Close the router, if it is ours, and never take the port again. May be called twice."""
        with self._lock:
            self._closed = True
            if self._router is not None:
                self._router.close()
                self._router = None
