"""Renewal of a router before its links have used up their numbers for keys.

Zenoh gives each key that it declares over a link a number from 1 to 65,535. It never frees a
number, and searches for the next free one from 1 on. So each new key takes longer than the one
before. At the end, the search never ends, and it holds a lock that all links of the router need.
Each program that starts brings some ten new keys (docs/design/zenoh-faults.md).

A new session begins with the keys that exist at this time. So a router closes its session and opens
a new one after many tokens have ended, in a moment without work.
"""

from __future__ import annotations

import contextlib
import threading
import time
from typing import TYPE_CHECKING

import zenoh

from zbot.threads.foreign_call import without_interruption

if TYPE_CHECKING:
    from collections.abc import Callable

# The tokens of nodes and endpoints, and those of transient local publishers (zenoh.ext).
_TOKENS = ("@zbot/**", "**/@adv/**")
#: Number of ended tokens after which a router is renewed, for a router with the programs of one
#: machine, and for one with those of a class or with clients. A node or endpoint brings a token,
#: and may bring two other keys: its topic and its cache. The keys of a token take 6 KB, and a new
#: router has 32 MB.
MACHINE_LIMIT = 1200
CLASS_LIMIT = 10_000
_QUIET_PART = 0.5  # of the limit: after so many, a router is renewed in a quiet moment
_QUIET_S = 0.5
_QUIET_SHARE = 0.02  # of a processor: an idle router with ten links uses less than 0.005


class RouterRenewal:
    """Counts the tokens that end, and asks for a new session of a router after many of them.

    Args:
        session: The router's session.
        renew: Function that is called in a thread, and may be called twice. It must return quickly.
        limit: The number of ended tokens after which it is called, also if the router works. While
            clients are linked, it is called only after `CLASS_LIMIT` tokens.
    """

    def __init__(
        self, session: zenoh.Session, renew: Callable[[], object], limit: int = MACHINE_LIMIT
    ) -> None:
        self._session: zenoh.Session | None = session
        self._renew = renew
        self._limit = limit
        self._quiet_limit = round(_QUIET_PART * limit)
        self._ended: set[int] = set()  # hashes of keys, because a key may be declared again
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._run, name="zbot renewal", daemon=True)
        self._beginning = threading.Lock()  # is never released: one thread begins
        for key in _TOKENS:
            receive = zenoh.handlers.Callback(self._receive)
            subscribe = session.liveliness().declare_subscriber
            without_interruption(subscribe, key, receive)

    def _receive(self, sample: zenoh.Sample) -> None:
        self.note(str(sample.key_expr), appeared=sample.kind == zenoh.SampleKind.PUT)

    def note(self, key: str, *, appeared: bool) -> None:
        """Note that a token begins or ends."""
        if appeared:
            self._ended.discard(hash(key))
            return
        self._ended.add(hash(key))
        # Two threads of Zenoh call this, so the limit may have been passed by more than one.
        if len(self._ended) >= self._quiet_limit and self._beginning.acquire(blocking=False):
            without_interruption(self._thread.start)

    def renew_after(self, tokens: int) -> None:
        """Ask for a new session now if at least so many tokens have ended."""
        if len(self._ended) >= tokens:
            self._renew()

    def _run(self) -> None:
        while len(self._ended) < CLASS_LIMIT:
            before, used_s = len(self._ended), time.process_time()
            if self._is_over.wait(_QUIET_S):
                return
            used_s = time.process_time() - used_s
            ended = len(self._ended)
            is_quiet = ended == before and used_s < _QUIET_SHARE * _QUIET_S
            if (is_quiet or ended >= self._limit) and not self._has_clients():
                break
        self._renew()

    def _has_clients(self) -> bool:
        """Return whether programs are linked whose messages pass the router, and would be lost."""
        assert self._session is not None
        with contextlib.suppress(zenoh.ZError):  # the session is being closed
            transports = self._session.info.transports()
            return any(transport.whatami == zenoh.WhatAmI.CLIENT for transport in transports)
        return False

    def end(self) -> None:
        """Stop counting. The session may still be open."""
        self._is_over.set()
        if self._thread.ident is not None:
            self._thread.join()
        self._session = None  # the session refers to this object, so it would never be freed
