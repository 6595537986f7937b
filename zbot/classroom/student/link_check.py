"""Check of the links of a machine's hub, to the domain's router and to the joined class or hub.

A router of Zenoh may lose a link and get it back at once. If other links of the router have changed
within the last 0.1 s, the router does not repeat its tokens, subscribers and queryables on the new
link (docs/design/zenoh-faults.md). Then e.g. the class does not see a node until the link is opened
again. This module finds out whether something is missing after a link was opened, and reopens the
hub if so.
"""

from __future__ import annotations

import os
import queue
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.errors import ClassroomError
from zbot.classroom.hub.queries import ask
from zbot.classroom.keys import HUB_KEY, MAX_LISTED_NODES, nodes_selector
from zbot.classroom.student.visibility import names_of
from zbot.log import get_logger
from zbot.threads.foreign_call import called_by_zenoh
from zbot.transport import admin_query
from zbot.transport.meeting_port import LOOPBACK, meeting_port
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.hub.process import HubProcess

    #: Returns what the class tells this laptop over its hub, or `None` if there is no answer.
    OfClass = Callable[[], dict[str, Any] | None]
    #: Asks the lobby of the class whether this laptop is in the class. `None` means no answer.
    IsMember = Callable[[], bool | None]

# Declarations need a short time, so the links are checked when they have not changed for this time.
_CALM_S = 1.0
_TIMEOUT_S = 1.0
# If reopening the hub does not help, something else may be wrong. So each wait is twice as long.
# A link that was lost since then is a new case.
_LONGEST_CALM_S = 600.0


class SilentClassError(ClassroomError):
    """The class answers neither over the link of this laptop's hub nor in its lobby."""

    def __init__(self) -> None:
        super().__init__("the class does not answer at the moment")


class LinkCheck:
    """Check of the links of a hub, in a thread of its own. The thread sleeps while no link changes.

    Args:
        domain: The domain of this machine's programs.
        of_class: Asks the class over the hub. `None` if the machine has joined a hub without a
            class.
        is_member: Asks the lobby of the class, with a session of its own.
    """

    def __init__(
        self, domain: int, of_class: OfClass | None, is_member: IsMember = lambda: None
    ) -> None:
        self._domain = domain
        self._of_class = of_class
        self._is_member = is_member
        self._faults = 0  # checks in a row that found something missing, or a silent class
        self._is_reopening = False

    def attach(self, serving: HubProcess) -> None:
        """Begin to check the links of a hub that was opened, until it is closed."""
        changes: queue.SimpleQueue[bool] = queue.SimpleQueue()  # `False` ends the thread
        self._is_reopening = False

        def on_event(event: Any) -> None:
            if event.transport.whatami == zenoh.WhatAmI.ROUTER:
                self._change(changes, is_lost=event.kind == zenoh.SampleKind.DELETE)

        events = called_by_zenoh(on_event)
        serving.keep(serving.session.info.declare_transport_events_listener(events, history=True))
        serving.call_on_close(lambda: changes.put(False))
        serving.start_thread("zbot link check", self._run, serving, changes)

    def _change(self, changes: queue.SimpleQueue[bool], *, is_lost: bool) -> None:
        if is_lost and not self._is_reopening:
            self._faults = 0
        changes.put(True)

    def _run(self, serving: HubProcess, changes: queue.SimpleQueue[bool]) -> None:
        while changes.get():
            calm_s = min(_CALM_S * 2**self._faults, _LONGEST_CALM_S)
            if not _is_calm(changes, calm_s):
                return
            try:
                missing = self._missing(serving)
                if missing and not _is_calm(changes, _CALM_S):
                    return
                again = self._missing(serving) if missing else missing
            except SilentClassError as error:
                self._faults += 1
                get_logger("hub").warning(str(error))
                changes.put(True)
                continue
            if not again:
                self._faults = 0
            elif missing & again:
                self._faults += 1
                get_logger("hub").warning(f"reopening the hub: {', '.join(sorted(again))}")
                self._is_reopening = True  # this loses all links
                serving.reopen()
            else:
                changes.put(True)  # e.g. nodes start and end at this moment

    def _missing(self, serving: HubProcess) -> set[str]:
        """Return what should be known across the links of a hub and is not.

        Raises:
            SilentClassError: The class does not answer, so nothing is known.
        """
        try:
            return self._missing_now(serving)
        except zenoh.ZError:  # the hub is being closed, or the router has ended
            return set()

    def _missing_now(self, serving: HubProcess) -> set[str]:
        nodes, missing = self._missing_at_router(serving.session)
        if self._of_class is None or not serving.is_linked():
            return missing
        told = self._of_class()
        if told is None:
            return missing | self._missing_answer()
        seen = told.get("nodes")
        if not isinstance(seen, list) or len(seen) >= MAX_LISTED_NODES:
            return missing  # the class does not know this laptop, or does not list all nodes
        if told.get("here") is False:
            missing.add("the class does not see this laptop")
        return missing | {f"the class does not see {name}" for name in nodes.difference(seen)}

    def _missing_answer(self) -> set[str]:
        """Return whether the link hides the class, which has not answered over it.

        A class that does not answer in its lobby either may be busy or suspended.
        """
        known = self._is_member()
        if known is None:
            raise SilentClassError
        # A class that does not accept this laptop does not answer it.
        return {"the class does not answer"} if known else set()

    def _missing_at_router(self, session: zenoh.Session) -> tuple[frozenset[str], set[str]]:
        """Return the nodes that the domain's router knows, and what is missing across its link.

        If the router is not linked with the hub, return nothing: the router dials again.
        """
        router = open_hub_client(f"tcp/{LOOPBACK}:{meeting_port(self._domain)}")
        if router is None:
            return frozenset(), set()
        with router:
            linked = {str(transport.zid) for transport in session.info.transports()}
            if linked.isdisjoint(map(str, router.info.routers_zid())):
                return frozenset(), set()
            nodes = self._nodes(router)
            missing = {f"the hub does not see {name}" for name in nodes - self._nodes(session)}
            if not ask(router, f"{HUB_KEY}/{os.getpid()}/link", timeout_s=_TIMEOUT_S):
                missing.add("the router does not see the hub")
        return nodes, missing

    def _nodes(self, session: zenoh.Session) -> frozenset[str]:
        return names_of(admin_query.tokens(session, nodes_selector(self._domain), _TIMEOUT_S))


def _is_calm(changes: queue.SimpleQueue[bool], calm_s: float) -> bool:
    """Wait until the links have not changed for a time. Return `False` if the hub is closed."""
    while True:
        try:
            if not changes.get(timeout=calm_s):
                return False
        except queue.Empty:
            return True
