"""Zenoh sessions, and the meeting point where the sessions of one domain find each other.

A small router process listens on the domain's meeting port, a TCP port of this machine. Sessions
with nodes connect to this router. The first sessions are Zenoh peers, and the router introduces
them to each other (see `Mesh`). Later sessions, and the sessions of commands, are clients of the
router.
"""

from __future__ import annotations

import os
import time
from typing import TYPE_CHECKING, Any

from zbot.threads.deadline import Deadline
from zbot.transport import membership, router_process
from zbot.transport.config import (
    DROP_WAIT_US,
    MEETING_PORT,
    ONE_DIALS,
    OPEN_TIMEOUT_MS,
    DiscoveryRange,
    SessionConfig,
    hub_port,
)
from zbot.transport.errors import SessionError
from zbot.transport.meeting_port import LOOPBACK, is_reserved, is_taken, meeting_port
from zbot.transport.mesh import Mesh
from zbot.transport.router_state import RouterState
from zbot.transport.zenoh_session import open_session, shares_memory

if TYPE_CHECKING:
    import zenoh

    from zbot.wire.dialect import Dialect

#: A router answers within 10 ms, or within seconds when 40 nodes start together on two cores.
LINK_TIMEOUT_S = 5.0
_QUESTIONS = 3  # a router that has just started may not answer the first question
_NEW_ROUTER_TIMEOUT_S = 2.0  # a router takes 0.1 s to start, and more on a busy machine
_LINK_PAUSE_S = 0.01
_YOUNG_S = 1.0  # a younger router may not have all links yet
_RELINK_PAUSE_S = 0.2  # longer than the pause between two tries to connect
_RECONNECTION_PAUSE_S = 0.3  # nodes try every 0.1 s, and less often on a busy machine
_FOUND_PAUSE_S = 0.25  # enough for all machines to answer multicast and then send their tokens
_WATCH_S = 0.2  # to see whether the router process does anything
_HUB_CLIENT_OPEN_TIMEOUT_MS = 500
_CLIENT_OPEN_TIMEOUT_MS = 200  # a router accepts a client within 5 ms if the machine is not busy
_BUSY_OPEN_TIMEOUT_MS = 2000
_CLIENT_TIMEOUT_MS = 2000  # the limit for one try to open a client session with nodes
_LINKED_CLIENT_TIMEOUT_S = 10.0
_NO_FILE = SessionConfig("the configuration between hubs", "{}")
# Zenoh never frees a session that had an admin space (18 KB), nor its configuration. That of a
# teacher's hub takes 15 MB, and the hub is opened again and again. No other machine gets an answer
# from the admin space of a hub, and nobody asks that of a hub's client.
_NO_ADMIN_SPACE = {"adminspace/enabled": False}
_RETRY = {"period_init_ms": 20, "period_max_ms": 500, "period_increase_factor": 2}
# A new router opens the port within 0.1 s. On one machine, a failed try takes little work.
_RETRY_MEETING = {"period_init_ms": 20, "period_max_ms": 100, "period_increase_factor": 1.5}
# The router tries less often to connect to the hub, because most machines have no hub, and each try
# wakes an idle node three times.
_RETRY_HUB = _RETRY | {"period_max_ms": 2000}


def _common(facts: dict[str, Any]) -> dict[str, Any]:
    return {
        "metadata": facts,
        "adminspace/enabled": True,
        "scouting/delay": 1,  # ms that Zenoh waits in open()
        "connect/timeout_ms": -1,
        "connect/exit_on_failure": False,
        "connect/retry": _RETRY,
        "transport/unicast/open_timeout": OPEN_TIMEOUT_MS,
        # Microseconds that a put may wait for a blocked reader before the reader's link is closed.
        "transport/link/tx/queue/congestion_control/block/wait_before_close": 60_000_000,
        # zbot puts large messages into shared memory itself (`transport/shared_memory.py`). Zenoh
        # would put messages of 3 KB or more there, which makes them no faster, and takes 16 MB of
        # each program.
        "transport/shared_memory/transport_optimization/enabled": False,
        **membership.session_settings(membership.load()),
    }


def open_hub(listen: list[str], connect: list[str], settings: dict[str, Any]) -> zenoh.Session:
    """Open the router session that links this machine with others. It has no admin space.

    Args:
        listen: Zenoh endpoints that must be free.
        connect: Zenoh endpoints to connect to. The hub retries while they do not answer.
        settings: Zenoh's configuration paths and values of the hub, besides those of all sessions.

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
        **_NO_ADMIN_SPACE,
        **settings,
    }
    return open_session("the hub", _NO_FILE.build(_common({}), force))


def _greatest_id() -> str:
    """Return a Zenoh id that is greater than the ids of all former routers of zbot.

    If a peer is linked to several routers, Zenoh lets only the router with the greatest id pass the
    peer's tokens on to the hub. A peer may seem to be linked to a former router, which was killed a
    moment ago (docs/design/zenoh-faults.md). In the comparison of ids, the last byte is the most
    significant, and an id must not begin with 0.
    """
    return "f" + os.urandom(8).hex()[1:] + time.time_ns().to_bytes(8, "little").hex()


def _warn(text: str, *, once: bool = False) -> None:
    from zbot.log import get_logger, warn_once  # noqa: PLC0415 - seldom used

    (warn_once if once else get_logger("zbot").warning)(text)


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
        "transport/unicast/open_timeout": _HUB_CLIENT_OPEN_TIMEOUT_MS,
        "scouting/multicast/enabled": False,
        **_NO_ADMIN_SPACE,
        **(more or {}),
    }
    try:
        return open_session("a Zenoh session", _NO_FILE.build(_common({}), settings))
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
        self._mesh = Mesh(domain)
        self._login = membership.login(membership.load())
        self.port = meeting_port(domain)
        self.dialect: Dialect | None = None  #: `None`: the context's own dialect
        self.is_client = True  #: whether the session of a command is a client of the router
        self.shares_memory = False  #: whether nodes may use shared memory for large messages
        self._closed = False
        # The watch of a router that has not answered this session's last question.
        self._unanswered: router_process.IdleWatch | None = None

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
            "id": _greatest_id(),
            "listen/endpoints": listen,
            "listen/timeout_ms": 0,
            "listen/exit_on_failure": True,
            "connect/endpoints": [hub_endpoint()],
            "connect/retry": _RETRY_HUB,
            **self._multicast(),
        }
        try:
            return open_session(
                "the meeting router", self._config.build(_common(self._facts), force)
            )
        except SessionError:
            return None

    def start_router(self) -> bool:
        """Start the domain's router process if no process has the meeting port.

        Nothing is started if the system reserves the port, or if the machine has joined or left a
        class since this process started.

        Returns:
            Whether this call started the process. The port is open about 0.1 s later.
        """
        self.end_stopped_router()
        # A router with another user name would not accept this process's sessions.
        is_possible = self._login == membership.login(membership.load())
        is_needed = is_possible and self.uses_port and not self.is_taken()
        is_useful = is_needed and not is_reserved(self.port)
        is_started = is_useful and router_process.start(self._domain)
        usual = MEETING_PORT + self._domain
        if is_started and self.port != usual:
            text = f"the system reserves port {usual}: programs meet on port {self.port}"
            _warn(f"{text}; `zbot doctor` says more", once=True)
        return is_started

    def end_stuck_router(self) -> bool:
        """Kill the domain's router process if it is suspended, or if it is idle without an answer.

        A router that works is not killed. A router of another user cannot be killed.

        Returns:
            Whether the process was killed. `start_router` can then start another.
        """
        if self.end_stopped_router():
            return True
        number = router_process.pid(self._domain)
        if number is None or router_process.age_s(self._domain) < _YOUNG_S:
            return False
        watch, self._unanswered = self._unanswered, None
        if watch is None or watch.number != number:
            watch = router_process.IdleWatch(number)
            if self._answers(is_patient=watch.saw_busy_machine):
                return False
        if not watch.is_idle(_WATCH_S):
            return False
        # Ask again on a busy machine, because this process itself may have been too slow.
        is_alive = watch.saw_busy_machine and self._answers(is_patient=True)
        return not is_alive and self._end_router(number)

    def end_stopped_router(self) -> bool:
        """Kill the domain's router process if it is suspended. Return whether it was killed."""
        number = router_process.pid(self._domain) if self.uses_port else None
        is_stopped = number is not None and router_process.is_stopped(number)
        return number is not None and is_stopped and self._end_router(number)

    def _answers(self, *, is_patient: bool) -> bool:
        session = self._open_client(self.endpoint, is_patient=is_patient)
        if session is None:
            return False
        with session:
            questions = _QUESTIONS if is_patient else 1
            return RouterState.of(session, questions=questions) is not None

    def _end_router(self, number: int) -> bool:
        if not router_process.kill(self._domain, number):
            return False
        _warn(
            f"the router of domain {self._domain} (process {number}) did not answer: "
            "it was ended, and another is started"
        )
        return True

    def is_expected(self) -> bool:
        """Return whether the domain has a router, or will have one soon."""
        return self.uses_port and (self.is_taken() or router_process.is_expected(self._domain))

    def is_foreign(self) -> bool:
        """Return whether a process that is not this user's router has the port."""
        has_router = router_process.pid(self._domain) is not None
        return self.is_taken() and not (has_router or router_process.is_changing(self._domain))

    @property
    def uses_port(self) -> bool:
        """Whether the domain's programs meet on the port. After `close`, this is `False`."""
        return self._reach is not DiscoveryRange.OFF and not self._closed

    def is_taken(self) -> bool:
        """Return whether a process listens on the meeting port."""
        return is_taken(self.port)

    @property
    def reaches_out(self) -> bool:
        """Whether the domain's programs search for other machines by multicast."""
        return self._reach is DiscoveryRange.SUBNET

    def open_node_session(self) -> zenoh.Session:
        """Open the session of a process with nodes: a peer, or a client if the mesh is full.

        Raises:
            SessionError: Zenoh cannot open the session, usually because of the configuration file.
        """
        fill = {
            "mode": "peer",
            "listen/endpoints": ["tcp/[::]:0"] if self.reaches_out else [f"tcp/{LOOPBACK}:0"],
            "connect/endpoints": [self.endpoint],
            "transport/link/tx/queue/congestion_control/drop/wait_before_drop": DROP_WAIT_US,
            "scouting/gossip/autoconnect_strategy": ONE_DIALS,
            **_common(self._facts),
            "connect/retry": _RETRY_MEETING,
            **self._multicast(),
        }
        if self._reach is DiscoveryRange.OFF:
            fill |= {"listen/endpoints": [], "connect/endpoints": []}
        elif not self._mesh.enter():
            fill |= {"mode": "client", "listen/endpoints": []}
        built = self._config.build(fill)
        self.shares_memory = shares_memory(built)
        if built.get_json("mode") == '"client"':
            return self._open_linked_client(fill)
        return open_session("a Zenoh session", built)

    def _open_linked_client(self, fill: dict[str, Any]) -> zenoh.Session:
        """Open a client session and link it to the router. Restart a router that ends meanwhile.

        Raises:
            SessionError: Zenoh cannot open the session within 10 s.
        """
        more = {"connect/timeout_ms": _CLIENT_TIMEOUT_MS, "connect/exit_on_failure": True}
        deadline = Deadline(_LINKED_CLIENT_TIMEOUT_S)
        while True:
            try:
                return open_session("a Zenoh session", self._config.build({**fill, **more}))
            except SessionError:
                if deadline.is_over:
                    raise
                self.start_router()

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
            # New programs wait for its answer in the admin space, so it has one. With shared
            # memory, a file would stay open after the session.
            "transport/shared_memory/enabled": False,
        }
        return open_session("a Zenoh session", self._config.build(_common({}), force))

    def open_tool_session(self, *, wait: bool) -> zenoh.Session | None:
        """Open the session of a command. Warn if another program has the port.

        Args:
            wait: Whether to start the domain's router if there is none.

        Returns:
            The session, or `None` if there is no router, or if it does not answer within about 8 s.
        """
        session, deadline = self.open_client(), Deadline(LINK_TIMEOUT_S)
        is_wanted = self.uses_port and (wait or self.reaches_out)
        while session is None and (is_wanted or self.is_expected()):
            if deadline.is_over or self.is_foreign():
                session = self.open_client(is_patient=True)  # the machine may be busy
                if session is None:
                    # The hub knows the nodes of the class.
                    session = self._open_client(hub_endpoint())
                if session is None:
                    self.warn_unanswered()
                return session
            self.end_stuck_router()
            session = self.open_new_client()
        is_off = self._reach is DiscoveryRange.OFF
        return session if session is not None or is_off else self._open_client_of_hub(deadline)

    def _open_client_of_hub(self, deadline: Deadline) -> zenoh.Session | None:
        """Open a client session of this machine's hub, which knows the nodes of other machines."""
        # A hub does not answer questions about itself, so it is not asked for its state.
        session = self._open_client(hub_endpoint())
        while session is None and membership.load() is not None and is_taken(hub_port()):
            if deadline.is_over:
                _warn("this machine's hub does not answer, so nodes of other machines are missing")
                return None
            session = self._open_client(hub_endpoint())
        return session

    def open_client(self, *, is_patient: bool = False) -> zenoh.Session | None:
        """Open a client session of the domain's router.

        Args:
            is_patient: Whether to wait longer for an answer, as on a busy machine.

        Returns:
            The session, or `None` if there is no router, or if it does not answer.
        """
        if self._reach is DiscoveryRange.OFF:
            return None
        self.end_stopped_router()
        number = router_process.pid(self._domain)
        is_old = number is not None and router_process.age_s(self._domain) >= _YOUNG_S
        watch = None if number is None else router_process.IdleWatch(number)
        session = self._open_client(self.endpoint, is_patient=is_patient)
        questions = 1 if is_old and not is_patient else _QUESTIONS
        state = None if session is None else RouterState.of(session, questions=questions)
        self._unanswered = watch if state is None else None
        if session is not None and state is None:
            session.close()  # the router accepts links, but answers nothing
            return None
        if session is not None and state is not None and state.age_s < _YOUNG_S:
            self._wait_for_links(session)
        return session

    def _open_client(self, endpoint: str, *, is_patient: bool = False) -> zenoh.Session | None:
        fill = {
            "mode": "client",
            "connect/endpoints": [endpoint],
            **_common(self._facts),
            "connect/timeout_ms": 0,
            "connect/exit_on_failure": True,
            "scouting/multicast/enabled": False,
        }
        is_patient = is_patient or router_process.is_machine_busy()
        timeout_ms = _BUSY_OPEN_TIMEOUT_MS if is_patient else _CLIENT_OPEN_TIMEOUT_MS
        fill["transport/unicast/open_timeout"] = timeout_ms
        try:
            return open_session("a Zenoh session", self._config.build(fill))
        except SessionError:
            return None

    def _wait_for_links(self, session: zenoh.Session) -> None:
        """Wait until the links of a new router have not changed for a time, at most 2 s."""
        settled_s = _FOUND_PAUSE_S if self.reaches_out else _RELINK_PAUSE_S
        known, since, deadline = frozenset[str](), time.monotonic(), Deadline(_NEW_ROUTER_TIMEOUT_S)
        while not deadline.is_over and time.monotonic() < since + settled_s:
            state = RouterState.of(session, all_routers=self.reaches_out, questions=_QUESTIONS)
            if state is not None and state.links != known:
                known, since = state.links, time.monotonic()
            if state is not None and state.is_replacement:
                # The nodes that had a link to the killed router connect again.
                settled_s = _RECONNECTION_PAUSE_S if len(known) > 1 else _NEW_ROUTER_TIMEOUT_S
            time.sleep(_LINK_PAUSE_S)

    def open_new_client(self) -> zenoh.Session | None:
        """Start the router, and open a client session. Return `None` if this fails for 2 s."""
        deadline = Deadline(_NEW_ROUTER_TIMEOUT_S)
        while not deadline.is_over:
            self.start_router()
            time.sleep(_LINK_PAUSE_S)
            session = self.open_client() if self.is_taken() else None
            if session is not None:
                return session
        return None

    def warn_unanswered(self) -> None:
        """Log once that no router of zbot answers on the port."""
        if is_reserved(self.port):
            text = f"the system reserves port {self.port}, so other nodes are not found"
            _warn(f"{text}; `zbot doctor` says more", once=True)
            return
        joined = membership.load()
        is_given = joined is not None and joined.in_class  # the number in the class is the domain
        advice = "" if is_given else ", or choose another domain, e.g. ZBOT_DOMAIN_ID=7"
        _warn(
            f"nobody answers as zbot on {self.endpoint}, so other nodes are not found: stop the "
            f"program that uses this port{advice}",
            once=True,
        )

    @staticmethod
    def router_tokens() -> list[str]:
        """Return an empty list: a session of zbot gets the tokens of all other sessions itself."""
        return []

    def close(self) -> None:
        """Leave the mesh, and never start a router from now on."""
        self._closed = True
        self._mesh.leave()
