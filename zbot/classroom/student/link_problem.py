"""Problem of the link between this machine's hub and the class or hub that it has joined."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import NoHubError
from zbot.classroom.hub.address import Address
from zbot.classroom.hub.link import Link
from zbot.classroom.hub.probe import problem_at
from zbot.classroom.student.lobby import is_member, open_lobby
from zbot.security.errors import SecurityError

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
#: Problems that may pass while a hub reconnects.
PASSING = (NOT_A_MEMBER, NOT_LINKED_YET, UNKNOWN, NOT_LINKED)


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
