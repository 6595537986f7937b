"""What this machine takes part in, as `zbot status` shows it."""

from __future__ import annotations

from typing import Any

from zbot import membership
from zbot.classroom import background
from zbot.classroom.desk import ask
from zbot.classroom.serving import HUB_KEY
from zbot.config import hub_port
from zbot.session import open_hub_client

_TIMEOUT_S = 1.0


def present_state() -> dict[str, Any]:
    """Return a document: role, address, whether the hub runs and whether it is linked."""
    joined, hub = membership.load(), background.find()
    facts = {} if hub is None else hub_facts(hub.pid)
    return {
        "role": joined.role if joined else hub.role if hub else None,
        "host": joined.host if joined else None,
        "port": joined.port if joined else hub_port() if hub else None,
        "class": joined.class_name if joined else None,
        "number": joined.number if joined else None,
        "name": joined.name if joined else None,
        "hub": hub is not None,
        "linked": facts.get("linked", False),
        "notices": facts.get("notices", []),
    }


def hub_facts(pid: int) -> dict[str, Any]:
    """Return what this machine's hub says of itself; empty if it does not answer."""
    session = open_hub_client()
    if session is None:
        return {}
    try:
        answers = ask(session, f"{HUB_KEY}/{pid}", timeout_s=_TIMEOUT_S)
    finally:
        session.close()
    return next((answer for answer in answers if answer.get("pid") == pid), {})
