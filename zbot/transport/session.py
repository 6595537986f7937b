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
import time
from pathlib import Path
from typing import Any, NamedTuple

import zenoh

from zbot.transport import admin_query, membership, router_process
from zbot.transport.config import MEETING_PORT, DiscoveryRange, SessionConfig, hub_port
from zbot.transport.errors import SessionError

LOOPBACK = "127.0.0.1"
_TAKEN_TIMEOUT_S = 0.1
_ANSWER_TIMEOUT_S = 0.3  # a router answers within 3 ms
_QUESTIONS = 3
_NEW_ROUTER_TIMEOUT_S = 2.0  # a router takes 0.1 s to start, and more on a busy machine
_LINK_PAUSE_S = 0.01
_YOUNG_S = 1.0  # a router of this age may not have all links yet
_RELINK_PAUSE_S = 0.2  # longer than the pause between two tries to connect
_FOUND_PAUSE_S = 0.25  # enough for all machines to answer multicast and then send their tokens
_WATCH_S = 0.3  # to see whether the router process does anything
_OPEN_TIMEOUT_MS = 500
# Time that a put with `DROP` waits for space in the queue. The queue is soon full if a busy machine
# does not run the sending thread. With Zenoh's default of 1000 us, bursts lost 14 to 37 % of their
# messages beside six busy processes. With 20 ms, one burst was lost. DDS waits 100 ms by default
# too. A subscriber that stands still makes its publisher wait once, and not at each message.
_DROP_WAIT_US = 100_000
_NO_FILE = SessionConfig("the configuration between hubs", "{}")
_RETRY = {"period_init_ms": 20, "period_max_ms": 500, "period_increase_factor": 2}
# A new router opens the port within 0.1 s. A try that nobody answers is cheap on one machine.
_RETRY_MEETING = {"period_init_ms": 20, "period_max_ms": 100, "period_increase_factor": 1.5}
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


class _RouterState(NamedTuple):
    """Links of a session's router, or of all routers, and the age of the youngest."""

    links: frozenset[str]
    age_s: float

    @classmethod
    def of(cls, session: zenoh.Session, *, all_routers: bool = False) -> _RouterState | None:
        """Ask the routers. Return `None` if no router answers."""
        for _ in range(_QUESTIONS):  # a router that has just started may not hear the first one
            links, ages = set[str](), list[float]()
            for router in ["*"] if all_routers else map(str, session.info.routers_zid()):
                for facts in admin_query.routers(session, router, _ANSWER_TIMEOUT_S):
                    links |= facts.sessions.keys()
                    ages.append((time.time_ns() - facts.started_ns) / 1e9)
            if ages:
                return cls(frozenset(links), min(ages))
        return None


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
        self._domain = domain
        self.port = MEETING_PORT + domain
        self.shares_memory = False  #: whether the peer may use shared memory for large messages
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

    def open_router(self) -> zenoh.Session | None:
        """Open the domain's router session on the meeting port. Only the router process calls this.

        Returns:
            The session, or `None` if another process has the port.
        """
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
            return _open("the meeting router", self._config.build(_common(self._facts), force))
        except SessionError:
            return None

    def start_router(self) -> bool:
        """Start the domain's router process if no process has the meeting port.

        Returns:
            Whether this call started the process. The port is open about 0.1 s later.
        """
        self._end_stopped_router()
        return self.uses_port and not self.is_taken() and router_process.start(self._domain)

    def end_stuck_router(self) -> bool:
        """Kill the domain's router process if it is stopped, or waits for ever and answers nothing.

        A router that works is not killed. A router of another user cannot be killed.

        Returns:
            Whether the process was killed. `start_router` can then start another.
        """
        if self._end_stopped_router():
            return True
        number = router_process.pid(self._domain)
        if number is None or router_process.age_s(self._domain) < _YOUNG_S or self._answers():
            return False
        if not router_process.is_idle(number, _WATCH_S):
            return False
        return self._end_router(number)

    def _end_stopped_router(self) -> bool:
        number = router_process.pid(self._domain) if self.uses_port else None
        is_stopped = number is not None and router_process.is_stopped(number)
        return number is not None and is_stopped and self._end_router(number)

    def _answers(self) -> bool:
        session = self._open_client([self.endpoint])
        if session is None:
            return False
        with session:
            return _RouterState.of(session) is not None

    def _end_router(self, number: int) -> bool:
        if not router_process.kill(self._domain, number):
            return False
        from zbot.log import get_logger  # noqa: PLC0415 - seldom used

        get_logger("zbot").warning(
            f"the router of domain {self._domain} (process {number}) did not answer: "
            "it was ended, and another is started"
        )
        return True

    def is_expected(self) -> bool:
        """Return whether the domain has a router, or will have one soon."""
        return self.uses_port and (self.is_taken() or router_process.is_expected(self._domain))

    def is_foreign(self) -> bool:
        """Return whether a process that is not this user's router has the port."""
        return self.is_taken() and router_process.pid(self._domain) is None

    @property
    def uses_port(self) -> bool:
        """Whether the domain's programs meet on the port, and this point is not closed."""
        return self._reach is not DiscoveryRange.OFF and not self._closed

    def is_taken(self) -> bool:
        """Return whether a process listens on the meeting port."""
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
    def reaches_out(self) -> bool:
        """Whether the domain's programs search for other machines by multicast."""
        return self._reach is DiscoveryRange.SUBNET

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
            "connect/retry": _RETRY_MEETING,
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
            The session, or `None` if there is neither router nor hub, or if none answers.
        """
        if self._reach is DiscoveryRange.OFF:
            return None
        self._end_stopped_router()
        # If this machine has no router, the hub still knows the nodes of other machines.
        session = self._open_client([self.endpoint, hub_endpoint()])
        state = None if session is None else _RouterState.of(session)
        if session is not None and state is None:
            session.close()  # the router accepts links, but answers nothing
            return None
        if session is not None and state is not None and state.age_s < _YOUNG_S:
            self._wait_for_links(session)
        return session

    def _open_client(self, endpoints: list[str]) -> zenoh.Session | None:
        fill = {
            "mode": "client",
            "connect/endpoints": endpoints,
            **_common(self._facts),
            "connect/timeout_ms": 0,
            "connect/exit_on_failure": True,
            "scouting/multicast/enabled": False,
        }
        try:
            return _open("a Zenoh session", self._config.build(fill))
        except SessionError:
            return None

    def _wait_for_links(self, session: zenoh.Session) -> None:
        """Wait until the links of a new router have not changed for a time, at most 2 s."""
        settled_s = _FOUND_PAUSE_S if self.reaches_out else _RELINK_PAUSE_S
        known, since = None, time.monotonic()
        deadline = since + _NEW_ROUTER_TIMEOUT_S
        while time.monotonic() < min(deadline, since + settled_s):
            state = _RouterState.of(session, all_routers=self.reaches_out)
            if state is not None and state.links != known:
                known, since = state.links, time.monotonic()
            time.sleep(_LINK_PAUSE_S)

    def open_new_client(self) -> zenoh.Session | None:
        """Start the router, and open a client session of it. Return `None` after 2 s."""
        deadline = time.monotonic() + _NEW_ROUTER_TIMEOUT_S
        while time.monotonic() < deadline:
            self.start_router()
            time.sleep(_LINK_PAUSE_S)
            session = self.open_client() if self.is_taken() else None
            if session is not None:
                return session
        return None

    def close(self) -> None:
        """Never start a router from now on."""
        self._closed = True
