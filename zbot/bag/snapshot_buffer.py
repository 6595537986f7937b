"""Newest messages of a recorder in snapshot mode. They are kept in memory until a snapshot."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from zbot.time import S_TO_NS

if TYPE_CHECKING:
    from zbot.bag.message import BagMessage


class SnapshotBuffer:
    """Ring of messages with a limit of bytes and of time. Only one thread may use the buffer.

    Args:
        max_bytes: Bytes of the messages. 0 means no limit.
        max_duration_s: Seconds between the oldest and the newest message. 0 means no limit.
    """

    def __init__(self, max_bytes: int, max_duration_s: float) -> None:
        self._max_bytes = max_bytes
        self._max_duration_ns = int(max_duration_s * S_TO_NS)
        self._messages: deque[BagMessage] = deque()
        self._bytes = 0

    def add(self, message: BagMessage) -> None:
        """Keep a message. Forget the oldest messages while a limit is exceeded."""
        self._messages.append(message)
        self._bytes += len(message.data)
        while len(self._messages) > 1 and self._is_over(message.log_ns):
            self._bytes -= len(self._messages.popleft().data)

    def take(self) -> list[BagMessage]:
        """Return all messages, the oldest first, and forget them."""
        taken = list(self._messages)
        self._messages.clear()
        self._bytes = 0
        return taken

    def _is_over(self, now_ns: int) -> bool:
        if self._max_bytes and self._bytes > self._max_bytes:
            return True
        age_ns = now_ns - self._messages[0].log_ns
        return bool(self._max_duration_ns) and age_ns > self._max_duration_ns
