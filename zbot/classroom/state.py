"""State of this machine's membership and hub, as `zbot status` prints it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.classroom import background
from zbot.classroom.address import Address
from zbot.classroom.hub_process import HUB_KEY
from zbot.classroom.hub_queries import ask
from zbot.classroom.invitation import invitation
from zbot.classroom.link import Link
from zbot.classroom.probe import problem_at
from zbot.security.errors import SecurityError
from zbot.transport import environment, membership, running_programs
from zbot.transport.config import hub_port
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from zbot.transport.membership import Membership

#: Problem of a laptop whose number or secret the class does not know.
NOT_ACCEPTED = (
    "the class does not accept this laptop: it was started anew, or it has given the number to "
    "another laptop; type `zbot leave`, and join again"
)
#: Problem of a machine whose hub cannot link to a hub that answers.
NOT_LINKED = (
    "the other machine answers, but its hub does not accept this machine: "
    "type `zbot leave`, and join again"
)

_RECONNECTED_S = 2.0
_PAUSE_S = 0.2
_TIMEOUT_S = 2.0  # the hub waits for the class at most 1.5 s


def present_state() -> dict[str, Any]:
    """Return the role, the address, whether the hub runs, whether it is linked, and so on."""
    joined, hub = membership.load(), background.find()
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
        "outside": running_programs.outside_text(),
        "differences": [one.text for one in environment.differences()],
    }


def _settled_facts(joined: Membership | None, pid: int) -> tuple[dict[str, Any], str | None]:
    """Return the facts of the hub, and the problem of its link.

    A hub that reconnects now is not linked for a moment, so a refusal counts only after 2 s.
    """
    deadline = time.monotonic() + _RECONNECTED_S
    while True:
        facts = hub_facts(pid)
        problem = link_problem(joined, facts) if joined else None
        if problem not in {NOT_ACCEPTED, NOT_LINKED} or time.monotonic() > deadline:
            return facts, problem
        time.sleep(_PAUSE_S)


def link_problem(joined: Membership, facts: dict[str, Any]) -> str | None:
    """Return why this machine's hub is not linked with the class or the other hub, or `None`.

    Args:
        joined: This machine's membership in the class or hub.
        facts: The facts that this machine's hub reports.
    """
    if not facts:
        return "the hub of this machine does not answer: `zbot leave` ends it"
    if joined.role == "teacher":
        return None
    if facts.get("linked"):
        is_accepted = not joined.in_class or facts.get("of_class") is not None
        return None if is_accepted else NOT_ACCEPTED
    unreachable = problem_at(Address(joined.host, joined.port))
    if unreachable is not None and facts.get("closed"):
        return "the teacher has closed the class: `zbot leave` leaves it"
    if unreachable is not None:
        return str(unreachable)
    return certificate_problem(joined) or (NOT_ACCEPTED if joined.in_class else NOT_LINKED)


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
