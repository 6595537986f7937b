"""Numbers of a session's nodes and endpoints. A new entity gets the number of an equal former one.

Zenoh keeps more than 1 kB for each key that a session has ever declared, and each new key takes
longer than the one before. The number of a node or endpoint is a part of its token's key. So an
entity that is created again, with the same name, type and profile, gets its former number and key.

Its gid is then the former gid too. So its messages are numbered where the former entity stopped.
Otherwise a server would take its first request for a repetition of a former request.
"""

from __future__ import annotations

import itertools
import threading
from collections import OrderedDict
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from zbot.wire.tokens import NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.wire.tokens import EndpointToken

    TokenT = TypeVar("TokenT", bound=NodeToken | EndpointToken)

# A program may use new names for ever. Then the numbers of the oldest entities are forgotten.
_MOST_DESCRIPTIONS = 10_000
_MOST_KEPT = 100


class EntityNumbers:
    """Numbers of the nodes and endpoints of one session. Any thread may call the methods."""

    def __init__(self) -> None:
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        self._unused = itertools.count()
        self._free: OrderedDict[str, list[int]] = OrderedDict()  # by description
        self._counters: dict[int, itertools.count[int]] = {}
        self._kept: OrderedDict[int, Any] = OrderedDict()

    def numbered(self, token: TokenT) -> TokenT:
        """Return the token of a new node or endpoint with a number that no other one has now."""
        description = _with_number(token, 0).key
        with self._lock:
            free = self._free.get(description)
            number = free.pop() if free else next(self._unused)
            if free == []:
                del self._free[description]
        return _with_number(token, number)

    def message_numbers(self, token: EndpointToken) -> Callable[[], int]:
        """Return a function that returns the numbers of an endpoint's messages, from 1 on.

        If an equal endpoint was destroyed before, the function continues that endpoint's numbers.
        """
        with self._lock:
            return self._counters.setdefault(token.eid, itertools.count(1)).__next__

    def release(self, token: NodeToken | EndpointToken) -> None:
        """Give the number of a destroyed node or endpoint back, for an equal one."""
        number = token.nid if isinstance(token, NodeToken) else token.eid
        description = _with_number(token, 0).key
        with self._lock:
            self._free.setdefault(description, []).append(number)
            self._free.move_to_end(description)
            if len(self._free) > _MOST_DESCRIPTIONS:
                for forgotten in self._free.popitem(last=False)[1]:
                    self._counters.pop(forgotten, None)

    def keep(self, token: EndpointToken, publisher: Any) -> None:
        """Keep the Zenoh publisher of a transient local publisher for an equal one.

        Call this before `release`. Zenoh gives each transient local publisher a number of its own,
        which is a part of a key. Late subscriptions get from the next publisher what this publisher
        has sent. The oldest ones are dropped if there are more than a hundred.
        """
        with self._lock:
            self._kept[token.eid] = publisher
            dropped = self._kept.popitem(last=False)[1] if len(self._kept) > _MOST_KEPT else None
        del dropped  # without the lock, because Zenoh undeclares it now

    def kept(self, token: EndpointToken) -> Any:
        """Return the Zenoh publisher that was kept for an equal endpoint, or `None`."""
        with self._lock:
            return self._kept.pop(token.eid, None)


def _with_number(token: TokenT, number: int) -> TokenT:
    field: dict[str, Any] = {"nid" if isinstance(token, NodeToken) else "eid": number}
    return replace(token, key="", **field)
