"""Publishers of a subscription's messages, with their sequence numbers, and the lost messages."""

from __future__ import annotations

import contextlib
import time
from typing import TYPE_CHECKING

from zbot.errors import counted
from zbot.log import get_logger, sinks_disabled
from zbot.names import ROSOUT_TOPIC

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from zbot.node.refusals import Refusals
    from zbot.wire.tokens import EndpointToken

# The largest number of publishers whose sequence numbers are kept. Each restart of a publisher adds
# a number. Without a limit, the memory use would grow for ever.
_MAX_SOURCES = 1024
_INFINITE_NS = 2**63 - 1


class MessageSource:
    """Publisher of received messages, with its next sequence number, lifespan and type mismatch."""

    __slots__ = ("is_special", "lifespan_ns", "next_sequence", "refusal")

    def __init__(
        self, next_sequence: int, *, refusal: str, lifespan_ns: int, checks_keys: bool
    ) -> None:
        self.next_sequence = next_sequence
        self.refusal = refusal  #: why its messages cannot be decoded, or an empty string
        self.lifespan_ns = lifespan_ns
        #: Whether `MessageSources.admits` must decide about each message.
        self.is_special = bool(lifespan_ns or refusal or checks_keys)


class MessageSources:
    """Publishers of a subscription's messages.

    Args:
        token: The subscription's token.
        find: Returns the publisher with a gid, or `None` if it is not known.
        refusals: The samples that cannot be read.
        losses: The messages that were lost.
    """

    def __init__(
        self,
        token: EndpointToken,
        find: Callable[[bytes], EndpointToken | None],
        refusals: Refusals,
        losses: LostMessages,
    ) -> None:
        self.by_gid: dict[bytes, MessageSource] = {}
        self._token = token
        self._find = find
        self._refusals = refusals
        self._losses = losses

    def admits(self, sample: zenoh.Sample, sequence: int, stamp_ns: int, gid: bytes) -> bool:
        """Return whether to decode a message. Count a gap in its publisher's sequence numbers.

        This is called for a publisher's first message, for a message after a gap, and for every
        message of a publisher with a lifespan or a wrong type.
        """
        source = self.by_gid.get(gid) or self._add(sample, sequence, gid)
        missing = sequence - source.next_sequence
        if missing > 0:  # else its threads overtook each other, or a cached message came again
            self._losses.add(missing)
        # A late message must not lower the number, or the next message would count as a loss.
        source.next_sequence = max(source.next_sequence, sequence + 1)
        if self._refusals.checks_keys and self._refusals.reason_of_type(sample):
            return False
        if source.refusal:
            self._refusals.add(source.refusal)
            return False
        return not source.lifespan_ns or time.time_ns() - stamp_ns <= source.lifespan_ns

    def _add(self, sample: zenoh.Sample, sequence: int, gid: bytes) -> MessageSource:
        if len(self.by_gid) >= _MAX_SOURCES:
            self.by_gid.clear()
        checks_keys = self._refusals.checks_keys
        source = self.by_gid[gid] = MessageSource(
            sequence,
            refusal="" if checks_keys else self._refusals.reason_of_type(sample),
            lifespan_ns=self._lifespan_ns(gid),
            checks_keys=checks_keys,
        )
        return source

    def _lifespan_ns(self, gid: bytes) -> int:
        """Return the shorter lifespan of a publisher's and the subscription's, or 0 for none."""
        publisher = self._find(gid)
        tokens = [self._token] if publisher is None else [self._token, publisher]
        lifespans = [token.qos.lifespan.nanoseconds for token in tokens]
        return min((span for span in lifespans if 0 < span < _INFINITE_NS), default=0)


class LostMessages:
    """Messages that were published but not received. The first loss is logged.

    Args:
        token: The subscription's token.
        logger_name: Name of the node's logger.
    """

    def __init__(self, token: EndpointToken, logger_name: str) -> None:
        self.count = 0
        #: Called with the number of lost messages. Nothing is logged if there is a listener.
        self.listeners: list[Callable[[int], None]] = []
        self._token = token
        self._logger_name = logger_name

    def add(self, missing: int) -> None:
        """Count lost messages."""
        is_first = self.count == 0
        self.count += missing
        for listener in self.listeners:
            listener(missing)
        if is_first and not self.listeners:
            self._warn(missing)

    def _warn(self, missing: int) -> None:
        # A warning about lost lines of /rosout must not be published on /rosout, because it would
        # push another line out of the full queue.
        own_cause = self._token.name == ROSOUT_TOPIC
        with sinks_disabled() if own_cause else contextlib.nullcontext():
            get_logger(self._logger_name).warning(
                f"{self._token.name}: {counted(missing, 'message')} lost: they come faster than "
                f"the callback takes them (queue depth {self._token.qos.depth}; further losses are "
                "only counted)"
            )
