"""Sessions that speak ROS 2's Zenoh dialect, and the router where they find each other.

Such sessions find each other through a router on port 7447, as the nodes of ROS 2 do. The user
starts this router: `rmw_zenohd` of ROS 2, or `zbot hub --rmw`.
"""

from __future__ import annotations

import itertools
import json
import os
import socket
import time
from typing import TYPE_CHECKING, Any

from zbot.threads.deadline import poll
from zbot.transport import admin_query
from zbot.transport.config import DiscoveryRange, setting
from zbot.transport.errors import NoRouterError, SessionError, no_router_text, router_port_error
from zbot.transport.process_facts import process_facts
from zbot.transport.rmw_config import (
    RmwConfig,
    endpoints,
    is_local,
    router_attempts,
)
from zbot.transport.zenoh_session import open_session, shares_memory
from zbot.version import __version__
from zbot.wire.rmw_zenoh import ROS2, dialect_of

if TYPE_CHECKING:
    import zenoh

    from zbot.wire.dialect import Dialect

_ATTEMPT_PAUSE_S = 1.0
_CHECK_PAUSE_S = 0.01
_LINK_TIMEOUT_S = 2.0  # a router on the same machine answers within 10 ms
# Peers of one machine are linked within 50 ms after a router has introduced them.
_PEERS_TIMEOUT_S = 1.0
_ANSWER_TIMEOUT_S = 0.5
_WHAT = "a Zenoh session"
_ROUTER_LISTENS = "tcp/[::]:7447"


class RmwMeeting:
    """Router of ROS 2, and the sessions of one domain that use the router.

    Args:
        reach: With OFF, no other program is found.
        facts: See `process_facts`.
        domain: 0 to 232.

    Raises:
        SettingError: A configuration file or the override variable is not valid.
    """

    uses_port = False

    def __init__(self, reach: DiscoveryRange, facts: dict[str, Any], domain: int) -> None:
        self._config = RmwConfig()
        self._is_off = reach is DiscoveryRange.OFF
        self._facts = facts
        self._token_keys = ROS2.token_selectors(domain)
        self._fill: dict[str, Any] = {"metadata": facts}
        built = self._config.session(self._fill)
        self._connect = endpoints(built, "connect/endpoints")
        self._is_client_by_config: bool = setting(built, "mode") == "client"
        self._has_multicast = setting(built, "scouting/multicast/enabled") is True
        self.shares_memory = shares_memory(built)
        self.is_client = (
            False  #: whether the session that was opened last is a client of the router
        )
        self._tokens: list[str] = []  # keys of the tokens that the router had at the start

    @property
    def dialect(self) -> Dialect:
        """The dialect that fits the ROS 2 distribution of the nodes at the router at the start."""
        return dialect_of(self._tokens, distro=os.environ.get("ROS_DISTRO", ""))

    def open_node_session(self) -> zenoh.Session:
        """Open the session of a process with nodes.

        If the router is on this machine, the session is a peer, as in ROS 2. If the router is on
        another machine, or if the session cannot be linked to all peers of the router, the session
        is a client, because a router of ROS 2 does not forward messages between two peers.

        Raises:
            SessionError: Zenoh cannot open the session.
            NoRouterError: The session must be a client, and no router answers.
            SettingError: The variable for the number of attempts is not valid.
        """
        if self._is_off:
            return self._open({}, {"connect/endpoints": [], "listen/endpoints": []})
        is_found = self._find_router()
        if self._must_be_client():
            if not is_found:  # a client cannot be opened, and Zenoh would try for ever
                raise NoRouterError(self._connect)
            return self._open_as_client()
        if self._config.names_mode:
            return self._open({})
        session = self._open({})
        if not is_found or self.is_client or self._links_all_peers(session):
            return session
        session.close()
        return self._open_as_client()

    def _must_be_client(self) -> bool:
        if self._is_client_by_config or self._config.names_mode:
            return self._is_client_by_config
        return not (self._has_multicast or all(map(is_local, self._connect)))

    def _open(self, fill: dict[str, Any], force: dict[str, Any] | None = None) -> zenoh.Session:
        built = self._config.session(self._fill | fill, force)
        self.is_client = setting(built, "mode") == "client"
        return open_session(_WHAT, built)

    def _open_as_client(self) -> zenoh.Session:
        force = {
            "mode": "client",
            "listen/endpoints": [],
            "connect/timeout_ms": 0,
            "connect/exit_on_failure": True,
        }
        return self._open({}, force)

    def _find_router(self) -> bool:
        """Look for a router, at most `router_attempts()` times. Return whether a router answers."""
        attempts = router_attempts()
        number = 0
        while attempts is None or number < max(attempts, 1):
            if number:
                time.sleep(_ATTEMPT_PAUSE_S)
            if self._ask_router():
                return True
            number += 1
            if number == 1 and not self._has_multicast and (attempts is None or attempts > 0):
                self.warn_unanswered()
        return False

    def _ask_router(self) -> bool:
        try:
            session = self._open_as_client()
        except SessionError:
            return False
        with session:
            self._tokens = self._tokens_at(session)
        return True

    def _tokens_at(self, session: zenoh.Session) -> list[str]:
        asked = [admin_query.tokens(session, key, _ANSWER_TIMEOUT_S) for key in self._token_keys]
        return list(itertools.chain.from_iterable(asked))

    def router_tokens(self) -> list[str]:
        """Return the keys of the router's tokens. If no router answers, return the last keys."""
        self._ask_router()
        return self._tokens

    def _links_all_peers(self, session: zenoh.Session) -> bool:
        """Wait until a session is linked to the router and to the peers that the router lists."""
        if not poll(session.info.routers_zid, _LINK_TIMEOUT_S, _CHECK_PAUSE_S):
            return True  # the router has ended meanwhile
        return poll(lambda: not self._unlinked(session), _PEERS_TIMEOUT_S, _CHECK_PAUSE_S)

    @staticmethod
    def _unlinked(session: zenoh.Session) -> set[str]:
        own = str(session.info.zid())
        found: dict[str, str] = {}
        for router in session.info.routers_zid():
            found |= admin_query.sessions(session, str(router), _ANSWER_TIMEOUT_S)
        linked = {str(zid) for zid in session.info.peers_zid()}
        return {zid for zid, kind in found.items() if kind == "peer"} - linked - {own}

    def open_tool_session(self, *, wait: bool) -> zenoh.Session | None:
        """Open the session of a command: a client of the router, or a peer with multicast.

        Args:
            wait: Whether the command publishes or subscribes, so that it needs the `dialect`.

        Returns:
            The session, or `None` if discovery is off.

        Raises:
            NoRouterError: No router answers.
        """
        if self._is_off:
            return None
        try:
            session = self._open_as_client()
        except SessionError:
            if self._has_multicast:
                return self._open({})
            raise NoRouterError(self._connect) from None
        if wait:
            self._tokens = self._tokens_at(session)
        return session

    def open_introducer(self) -> zenoh.Session:
        """Open a peer without a node. Peers link to it, and it introduces them to each other.

        Raises:
            SessionError: Zenoh cannot open the session.
        """
        return self._open({}, {"mode": "peer", "listen/endpoints": []})

    def start_router(self) -> bool:
        """Return False: the user starts the router."""
        return False

    def end_stuck_router(self) -> bool:
        """Return False: the router may be a program of ROS 2."""
        return False

    def end_stopped_router(self) -> bool:
        """Return False: the router may be a program of ROS 2."""
        return False

    def warn_unanswered(self) -> None:
        """Log once that no router answers."""
        from zbot.log import warn_once  # noqa: PLC0415 - seldom used

        warn_once(no_router_text(self._connect))

    def close(self) -> None:
        """Do nothing: no port belongs to this program."""


class RmwRouter:
    """Router like ROS 2's `rmw_zenohd`.

    Args:
        listen: Zenoh endpoints to listen on. If empty, the endpoints of the configuration file are
            used, else port 7447 of all interfaces.
        connect: Zenoh endpoints of other routers, in addition to those of the configuration file.

    Raises:
        SettingError: A configuration file or the override variable is not valid.
    """

    def __init__(self, listen: list[str], connect: list[str]) -> None:
        config = RmwConfig()
        fill = {
            "metadata": process_facts(__version__),
            "listen/endpoints": [_ROUTER_LISTENS],
        }
        force: dict[str, Any] = {"listen/endpoints": listen} if listen else {}
        if connect:
            known = endpoints(config.router(fill, {}), "connect/endpoints")
            force["connect/endpoints"] = [*known, *connect]
        self._config = config.router(fill, force)
        self.listen = endpoints(self._config, "listen/endpoints")
        if self.listen == [_ROUTER_LISTENS] and not socket.has_dualstack_ipv6():
            self.listen = [_ROUTER_LISTENS.replace("[::]", "0.0.0.0")]  # noqa: S104 - as rmw_zenohd
            self._config.insert_json5("listen/endpoints", json.dumps(self.listen))

    def open(self) -> zenoh.Session:
        """Open the router's session.

        Raises:
            TransportError: An endpoint is in use.
        """
        try:
            return open_session("the router", self._config)
        except SessionError as error:
            raise router_port_error(self.listen, error.reason) from error
