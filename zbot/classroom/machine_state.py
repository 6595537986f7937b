"""State of this machine's membership and hub, as `zbot status` prints it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import NoHubError
from zbot.classroom.hub import running_hub
from zbot.classroom.hub.address import Address
from zbot.classroom.hub.link import Link
from zbot.classroom.hub.probe import problem_at
from zbot.classroom.hub.queries import ask
from zbot.classroom.keys import HUB_KEY
from zbot.classroom.student.lobby import is_member, open_lobby
from zbot.classroom.teacher.invitation import invitation
from zbot.security.errors import SecurityError
from zbot.threads.deadline import Deadline
from zbot.transport import environment, membership, running_programs
from zbot.transport.config import hub_port
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from zbot.transport.membership import Membership

#: Problem of a laptop that the class does not know.
NOT_A_MEMBER = (
    "the class does not accept this laptop: the teacher has freed its number, has begun a new "
    "period, or has started the class anew; type `zbot leave`, and join again"
)
#: Problem of a laptop that the class knows, but whose hub is not linked.
NOT_LINKED_YET = (
    "the class knows this laptop, but the link is not there yet: the laptop links by itself; if "
    "it has no link after a minute, type `zbot leave`, and join again"
)
#: Problem of a machine whose hub is not linked, while the other hub does not answer.
UNKNOWN = (
    "the other machine does not answer at the moment, it may be busy or suspended: this machine "
    "links by itself as soon as the other machine answers"
)
#: Problem of a machine that has joined a hub without a class, if that hub is now another one.
NOT_LINKED = (
    "the other machine answers, but its hub does not accept this machine: "
    "type `zbot leave`, and join again"
)
_PASSING = (NOT_A_MEMBER, NOT_LINKED_YET, UNKNOWN, NOT_LINKED)

_RECONNECTED_S = 2.0
_PAUSE_S = 0.2
_TIMEOUT_S = 2.0  # the hub waits for the class at most 1.5 s


def present_state() -> dict[str, Any]:
    """Return the role, the address, whether the hub runs, whether it is linked, and so on."""
    joined, hub = membership.load(), running_hub.find()
    facts, problem = ({}, None) if hub is None else _settled_facts(joined, hub.pid)
    of_class = facts.get("of_class") or {}
    return {
        "role": joined.role if joined else hub.role if hub else None,
        "host": joined.host if joined else None,
        "port": joined.port if joined else hub_port() if hub else None,
        "class": joined.class_name if joined else None,
        "number": joined.number if joined else None,
        "name": joined.name if joined else None,
        "hub": hub is not None,
        "linked": facts.get("linked", False),
        "problem": problem,
        "join": invitation().document() if joined and joined.role == "teacher" else None,
        "notices": of_class.get("notices", []),
        "namesakes": of_class.get("namesakes") or [],
        "outside": running_programs.outside_text(),
        "differences": [one.text for one in environment.differences()],
    }


def _settled_facts(joined: Membership | None, pid: int) -> tuple[dict[str, Any], str | None]:
    """Return the facts of the hub, and the problem of its link.

    A hub that reconnects now is not linked for a moment, so this counts only after 2 s.
    """
    deadline = Deadline(_RECONNECTED_S)
    while True:
        facts = hub_facts(pid)
        problem = link_problem(joined, facts) if joined else None
        if problem not in _PASSING or deadline.is_over:
            return facts, problem
        time.sleep(_PAUSE_S)


def link_problem(joined: Membership, facts: dict[str, Any]) -> str | None:
    """Return why this machine's hub is not linked with the class or the other hub, or `None`.

    Args:
        joined: This machine's membership in the class or hub.
        facts: The facts that this machine's hub reports.
    """
    if not facts:
        # The hub may be opened again at this moment, see `link_check`.
        return (
            "the hub of this machine does not answer at the moment: type `zbot status` again; if "
            "it never answers, `zbot leave` ends it"
        )
    if joined.role == "teacher":
        return None
    if is_accepted(joined, facts):
        return None
    unreachable = problem_at(Address(joined.host, joined.port))
    if unreachable is not None and facts.get("closed"):
        return "the teacher has closed the class: `zbot leave` leaves it"
    if unreachable is not None:
        return str(unreachable)
    return certificate_problem(joined) or _refusal(joined)


def is_accepted(joined: Membership, facts: dict[str, Any]) -> bool:
    """Return whether this machine's hub is linked, and a class has given it the owner's facts.

    Args:
        joined: This machine's membership in the class or hub.
        facts: The facts that this machine's hub reports.
    """
    is_owner = (facts.get("of_class") or {}).get("nodes") is not None
    return bool(facts.get("linked")) and (is_owner or not joined.in_class)


def _refusal(joined: Membership) -> str:
    """Return why a hub whose port is open is not linked with this machine."""
    if joined.in_class:
        known = is_member(joined)
        return UNKNOWN if known is None else NOT_LINKED_YET if known else NOT_A_MEMBER
    try:
        session, _ = open_lobby(Address(joined.host, joined.port), Link(joined.keystore))
    except NoHubError as error:
        return UNKNOWN if error.is_silent else NOT_LINKED
    session.close()
    return NOT_LINKED


def certificate_problem(joined: Membership) -> str | None:
    """Return the problem of this machine's certificate, or of the other hub's certificate.

    Return `None` if both certificates are valid, or if the hub does not answer.
    """
    try:
        Link(joined.keystore).check_dialling(Address(joined.host, joined.port))
    except SecurityError as error:
        return str(error)
    except OSError:
        return None  # no machine answers at the address
    return None


def hub_facts(pid: int) -> dict[str, Any]:
    """Return the facts that this machine's hub reports. Empty if the hub does not answer."""
    session = open_hub_client()
    if session is None:
        return {}
    try:
        answers = ask(session, f"{HUB_KEY}/{pid}", timeout_s=_TIMEOUT_S)
    finally:
        session.close()
    return next((answer for answer in answers if answer.get("pid") == pid), {})
