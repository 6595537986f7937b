"""State of this machine's membership and hub, as `zbot status` prints it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.classroom.hub import running_hub
from zbot.classroom.hub.queries import hub_facts
from zbot.classroom.student.link_problem import PASSING, is_accepted, link_problem
from zbot.classroom.teacher.invitation import invitation
from zbot.threads.deadline import Deadline
from zbot.transport import environment, membership, running_programs
from zbot.transport.config import hub_port

if TYPE_CHECKING:
    from zbot.transport.membership import Membership

_RECONNECTED_S = 2.0
_PAUSE_S = 0.2


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
        "differences": [setting.text for setting in environment.differences()],
    }


def _settled_facts(joined: Membership | None, pid: int) -> tuple[dict[str, Any], str | None]:
    """Return the facts of the hub, and the problem of its link.

    A hub that reconnects now is not linked for a moment, so this counts only after 2 s.
    """
    deadline = Deadline(_RECONNECTED_S)
    while True:
        facts = hub_facts(pid)
        problem = link_problem(joined, facts) if joined else None
        if joined is None or problem not in PASSING:
            return facts, problem
        if deadline.is_over:
            # On a slow network, it takes long to find out the problem. The hub may be linked now.
            facts = hub_facts(pid)
            return facts, None if is_accepted(joined, facts) else problem
        time.sleep(_PAUSE_S)
