"""Visibility of this machine's nodes for the hub of the machine and for the class."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.classroom.hub import running_hub
from zbot.classroom.hub.queries import hub_facts
from zbot.classroom.keys import nodes_selector
from zbot.names import is_hidden
from zbot.threads.deadline import Deadline
from zbot.transport import admin_query, membership, running_programs
from zbot.transport.config import domain_id
from zbot.transport.session import open_hub_client
from zbot.wire.errors import TokenError
from zbot.wire.tokens import NodeToken, parse_token

if TYPE_CHECKING:
    from collections.abc import Iterable

_TIMEOUT_S = 1.0
# A new domain's router tries every 2 s to connect to the hub, and a hub reconnects within 0.5 s.
_SETTLED_S = 4.0
_PAUSE_S = 0.25


@dataclass(frozen=True)
class Visibility:
    """Full names of the nodes of this machine's domain. Hidden nodes are left out."""

    running: frozenset[str]  #: nodes of this user's programs that the hub and the class should see
    hub: frozenset[str]  #: nodes that this machine's hub sees
    of_class: frozenset[str] | None = field(default=None)  #: nodes that the class sees, if known

    def problems(self) -> list[str]:
        """Return a sentence about the nodes that the hub, or else the class, does not see."""
        found = []
        if self.running - self.hub:
            found.append(f"the hub of this machine does not see {_listed(self.running - self.hub)}")
        elif self.of_class is not None and self.running - self.of_class:
            found.append(f"the class does not see {_listed(self.running - self.of_class)}")
        return found


def _listed(names: Iterable[str]) -> str:
    return ", ".join(sorted(names))


def settled() -> Visibility | None:
    """Return the visibility as soon as it has no problems, at the latest after 4 s.

    Returns:
        The visibility, or `None` if this machine has no hub.
    """
    deadline = Deadline(_SETTLED_S)
    while (found := visibility()) is not None and found.problems() and not deadline.is_over:
        time.sleep(_PAUSE_S)
    return found


def visibility() -> Visibility | None:
    """Return the visibility at this moment, or `None` if this machine has no hub that answers."""
    hub = running_hub.find()
    session = open_hub_client() if hub is not None else None
    if hub is None or session is None:
        return None
    domain = domain_id()
    with session:
        keys = list(admin_query.tokens(session, nodes_selector(domain), _TIMEOUT_S))
    # If the class does not answer, `of_class` is `None`, and `zbot status` reports the problem.
    seen = (hub_facts(hub.pid).get("of_class") or {}).get("nodes")
    return Visibility(
        _running(domain),
        names_of(keys),
        frozenset(map(str, seen)) if isinstance(seen, list) else None,
    )


def _running(domain: int) -> frozenset[str]:
    joined = membership.load()
    return frozenset(
        name
        for program in running_programs.running()
        if program.domain == domain and not program.is_tool and not program.reason(joined)
        for name in program.visible_nodes
    )


def names_of(keys: Iterable[str]) -> frozenset[str]:
    """Return the full names of the nodes that some tokens announce. Hidden nodes are left out."""
    tokens: list[Any] = []
    for key in keys:
        try:
            tokens.append(parse_token(key))
        except TokenError:
            continue  # any program may declare any token in its domain
    nodes = (token for token in tokens if type(token) is NodeToken)
    names = (node.full_node_name for node in nodes)
    return frozenset(name for name in names if not is_hidden(name))
