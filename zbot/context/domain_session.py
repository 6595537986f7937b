"""Zenoh session of a context, with its way to the other sessions of the domain."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from zbot.log.teacher_notice import NOTICE_KEY, log_notice
from zbot.process import blocked_put, fork
from zbot.threads.foreign_call import without_interruption
from zbot.transport import config, environment, membership, zenoh_session
from zbot.transport.peering import Peering
from zbot.transport.process_facts import process_facts
from zbot.transport.rmw_choice import RMW_ZENOH, dialect_of_rmw
from zbot.transport.running_programs import Registration
from zbot.transport.session import MeetingPoint
from zbot.version import __version__
from zbot.wire.dialect import NATIVE

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from zbot.transport.rmw_meeting import RmwMeeting

# Longest waits before the first graph query and before the first message. Such a wait usually takes
# 2 ms.
_DISCOVERY_TIMEOUT_S = 2.0
_PEERS_TIMEOUT_S = 0.5


class DomainSession:
    """Zenoh session in a domain. Nothing is open before `open` or `open_tool`.

    Args:
        mode: `peer` for a process with nodes, or `client` for a tool.
        rmw: The middleware, or `None` for that of the settings.
        receiver: Returns a Zenoh handler that calls a function (see `SessionThreads.receiver`).
        when_open: Called when the session is open, before anything uses it.
    """

    def __init__(
        self,
        mode: Literal["peer", "client"],
        rmw: str | None,
        receiver: Callable[..., Any],
        when_open: Callable[[], object],
    ) -> None:
        self.is_tool = mode == "client"
        self.asks_router = self.is_tool
        self.dialect = NATIVE
        self.is_student = False
        self.session: zenoh.Session | None = None
        self._rmw = rmw
        self._receiver = receiver
        self._when_open = when_open
        self._in_class = False
        self._meeting: MeetingPoint | RmwMeeting | None = None
        self._peering: Peering | None = None
        self._registration: Registration | None = None

    def choose_domain(self, given_domain: int | None) -> None:
        """Read the domain, the class that this machine has joined, and the dialect.

        Raises:
            SettingError: The domain is out of range, or the middleware is not known.
        """
        self.domain, self._given_domain = config.domain_id(given_domain), given_domain
        joined = membership.load()
        self._in_class = joined is not None and joined.in_class
        self.is_student = joined is not None and joined.role == "student"
        self.dialect = dialect_of_rmw(self._rmw, in_class=self._in_class)

    def open(self, is_over: Callable[[], bool]) -> None:
        """Open the session, and start the domain's router if there is none.

        Args:
            is_over: Returns whether the context was shut down.
        """
        if self.is_tool:
            self.open_tool(wait=True)
            return
        meeting = self._new_meeting()
        meeting.start_router()
        session = meeting.open_node_session()
        self._keep(session, meeting)
        if self._in_class:
            receiver = self._receiver(log_notice, may_wait=True)
            without_interruption(session.declare_subscriber, NOTICE_KEY, receiver)
        if self._peering is not None:
            self._peering.link(is_over)

    def open_tool(self, *, wait: bool) -> None:
        """Open a tool's session if the domain has a router.

        Args:
            wait: Whether to start the domain's router if there is none.
        """
        meeting = self._new_meeting()
        session = meeting.open_tool_session(wait=wait)
        if session is not None:
            self.asks_router = meeting.is_client
            self._keep(session, meeting, watch=wait)
        elif wait:  # without a router, use a node's session, which finds other nodes itself
            self._keep(meeting.open_node_session(), meeting)

    def _new_meeting(self) -> MeetingPoint | RmwMeeting:
        zenoh_session.prepare()
        reach, facts = config.discovery_range(), process_facts(__version__)
        file = config.load()
        self.dialect = dialect_of_rmw(self._rmw, in_class=self._in_class, file=file)
        if self.dialect.identifier == RMW_ZENOH:
            from zbot.transport.rmw_meeting import RmwMeeting  # noqa: PLC0415 - few programs need it

            return RmwMeeting(reach, facts, self.domain)
        environment.warn(self._given_domain)
        return MeetingPoint(file, self.domain, reach, facts)

    def _keep(
        self, session: zenoh.Session, meeting: MeetingPoint | RmwMeeting, *, watch: bool = True
    ) -> None:
        # The order matters: if Ctrl-C comes in between, `close` must find everything that is open.
        self.session, self._meeting = session, meeting
        self.dialect = meeting.dialect or self.dialect
        self._when_open()
        if watch:
            self._registration = Registration(self.domain, is_tool=self.is_tool)
            self._peering = Peering(session, meeting, self._receiver)
            self._peering.start()

    @property
    def is_closed(self) -> bool:
        """Whether there is no open session."""
        return self.session is None or self.session.is_closed()

    @property
    def shares_memory(self) -> bool:
        """Whether large messages go into shared memory."""
        return self._meeting is not None and self._meeting.shares_memory

    def add_node(self, name: str) -> None:
        """Tell the other programs of this machine about a node."""
        if self._registration is not None:
            self._registration.add(name)

    def remove_node(self, name: str) -> None:
        """Undo `add_node`."""
        if self._registration is not None:
            self._registration.remove(name)

    def unreachable(self) -> tuple[set[str], list[str]]:
        """Return the sessions from which no message can come, and the tokens of the router."""
        meeting, zids = self._meeting, self._peering.unreachable() if self._peering else set()
        return zids, meeting.router_tokens() if meeting is not None and zids else []

    def wait_for_discovery(self) -> None:
        """Wait until every session of the domain has answered this session, at most 2 s."""
        if not self.is_closed:
            self._wait_for_answers(_DISCOVERY_TIMEOUT_S)

    def wait_for_peers(self) -> None:
        """Wait until this session knows all present subscriptions, at most 0.5 s."""
        self._wait_for_answers(_PEERS_TIMEOUT_S)

    def _wait_for_answers(self, timeout_s: float) -> None:
        if not self.asks_router and self._peering is not None:
            self._peering.wait_for_answers(timeout_s)

    def close(self, join_threads: Callable[[], None]) -> None:
        """Close the session.

        Args:
            join_threads: Waits for the threads that use the session.
        """
        # The session is closed first, because this ends the threads that wait for its data.
        if self.session is not None:
            blocked_put.cancel_all([self.session])
            self.session.close()
        if self._registration is not None:
            self._registration.close()
        join_threads()
        if self._peering is not None:
            self._peering.join()
        if self._meeting is not None:
            self._meeting.close()

    def leave_to_parent(self) -> None:
        """In a forked child, leave the session to the parent process."""
        fork.keep(dict(vars(self)))
        if self._registration is not None:
            self._registration.leave_to_parent()
        self.session = self._meeting = self._peering = self._registration = None
