"""State of this machine's membership and hub, as `zbot status` prints it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.classroom import background
from zbot.classroom.address import Address
from zbot.classroom.hub_process import HUB_KEY
from zbot.classroom.hub_queries import ask
from zbot.classroom.link import Link
from zbot.security.errors import SecurityError
from zbot.transport import membership
from zbot.transport.config import hub_port
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from zbot.transport.membership import Membership

_TIMEOUT_S = 1.0


def present_state() -> dict[str, Any]:
    """Return the role, the address, whether the hub runs, whether it is linked, and so on."""
    joined, hub = membership.load(), background.find()
    facts = {} if hub is None else hub_facts(hub.pid)
    is_linked = facts.get("linked", False)
    return {
        "role": joined.role if joined else hub.role if hub else None,
        "host": joined.host if joined else None,
        "port": joined.port if joined else hub_port() if hub else None,
        "class": joined.class_name if joined else None,
        "number": joined.number if joined else None,
        "name": joined.name if joined else None,
        "hub": hub is not None,
        "linked": is_linked,
        "problem": certificate_problem(joined) if joined and hub and not is_linked else None,
        "notices": facts.get("notices", []),
    }


def certificate_problem(joined: Membership) -> str | None:
    """Return the problem of this machine's certificate, or of the certificate of the dialled hub.

    Return `None` if both certificates are valid, or if the hub does not answer.
    """
    if joined.role == "teacher":
        return None
    try:
        Link(joined.keystore).check_dialling(Address(joined.host, joined.port))
    except SecurityError as error:
        return str(error)
    except OSError:
        return None  # no machine answers there
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
