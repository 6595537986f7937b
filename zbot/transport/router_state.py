"""State of the routers of a domain, as they describe themselves in Zenoh's admin space."""

from __future__ import annotations

import itertools
import time
from typing import TYPE_CHECKING, NamedTuple

from zbot.transport import admin_query

if TYPE_CHECKING:
    import zenoh

_ANSWER_TIMEOUT_S = 0.3  # a router answers within 3 ms


class RouterState(NamedTuple):
    """Links of a session's router, or of all routers, and the age of the youngest router."""

    links: frozenset[str]
    age_s: float
    is_replacement: bool  #: whether one of the routers replaces a router that was killed

    @classmethod
    def of(
        cls, session: zenoh.Session, *, all_routers: bool = False, questions: int
    ) -> RouterState | None:
        """Ask the routers. Return `None` if no router answers. Hubs do not answer.

        Args:
            session: A session that is linked to a router.
            all_routers: Whether to ask all routers, and not only the session's own.
            questions: How often to ask. Each question waits at most 0.3 s.
        """
        for _ in range(questions):
            found: list[admin_query.RouterFacts] = []
            for router in ["*"] if all_routers else map(str, session.info.routers_zid()):
                found += admin_query.routers(session, router, _ANSWER_TIMEOUT_S)
            if found:
                youngest_ns = max(facts.started_ns for facts in found)
                return cls(
                    frozenset(itertools.chain.from_iterable(facts.sessions for facts in found)),
                    (time.time_ns() - youngest_ns) / 1e9,
                    any(facts.is_replacement for facts in found),
                )
        return None
