"""Filter of a topic's messages by their senders: what a bridge has sent is left out."""

from __future__ import annotations

import time
from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.bridge.routes import Log

# A message may come before ROS 2 tells which node sent it. Such messages wait at most this long.
_UNKNOWN_SENDER_S = 3.0
_MOST_BYTES = 20_000_000  #: of the messages of one sender that wait


@dataclass(eq=False)
class _Unknown:
    """Sender that ROS 2 has not told yet."""

    patient_until_s: float
    waiting: deque[bytes] = field(default_factory=deque)
    size: int = 0  #: bytes of the messages that wait


class SenderFilter:
    """Filter of the messages of one topic. Only one thread may call the methods.

    The messages of each sender keep their order. A sender that ROS 2 does not tell in 3 s counts as
    a node that is no bridge.

    Args:
        name: The topic.
        is_of_bridge: Returns whether a sender is a bridge, or `None` if it is not known yet.
        receive: Called with each message that is not a bridge's.
        log: Gets a line when too many messages wait.
        clock: Returns the time in seconds.
    """

    def __init__(
        self,
        name: str,
        is_of_bridge: Callable[[str, bytes], bool | None],
        receive: Callable[[bytes], None],
        log: Log,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._name, self._is_of_bridge = name, is_of_bridge
        self._receive, self._log, self._clock = receive, log, clock
        self._unknown: dict[bytes, _Unknown] = {}
        self._has_dropped = False

    def take(self, sender: bytes, data: bytes) -> None:
        """Pass on a message, or let it wait until its sender is known."""
        is_of_bridge = self._is_of_bridge(self._name, sender)
        if is_of_bridge is None or sender in self._unknown:
            self._hold(sender, data)
            self._release(sender, is_of_bridge)
        elif not is_of_bridge:
            self._receive(data)

    def release(self) -> None:
        """Pass on the messages whose senders are known now, or have been unknown for too long."""
        for sender, unknown in list(self._unknown.items()):
            if unknown.waiting:
                self._release(sender, self._is_of_bridge(self._name, sender))

    def _hold(self, sender: bytes, data: bytes) -> None:
        unknown = self._unknown.get(sender)
        if unknown is None:
            unknown = self._unknown[sender] = _Unknown(self._clock() + _UNKNOWN_SENDER_S)
        unknown.waiting.append(data)
        unknown.size += len(data)
        while unknown.size > _MOST_BYTES and len(unknown.waiting) > 1:
            unknown.size -= len(unknown.waiting.popleft())
            self._tell_dropped()

    def _release(self, sender: bytes, is_of_bridge: bool | None) -> None:
        unknown = self._unknown[sender]
        if is_of_bridge is not None:
            del self._unknown[sender]
        elif self._clock() < unknown.patient_until_s:
            return
        waiting, unknown.waiting, unknown.size = unknown.waiting, deque(), 0
        if not is_of_bridge:
            for data in waiting:
                self._receive(data)

    def _tell_dropped(self) -> None:
        if not self._has_dropped:
            self._has_dropped = True
            self._log.warning(
                f"{self._name}: messages are dropped until ROS 2 tells which node sent them "
                f"(more than {_MOST_BYTES // 1_000_000} MB wait)"
            )
