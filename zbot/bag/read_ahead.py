"""Messages that a thread reads in advance, so that reading does not delay the playback."""

from __future__ import annotations

import heapq
import queue
import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.bag.message import BagMessage


_POLL_S = 0.1
# Number of messages in a batch. Each batch wakes the player's thread, which takes longer than
# reading a message. But the player waits for Python's lock while a batch is read, at most 0.5 ms.
_BATCH = 16


class ReadAhead:
    """Queue that a thread fills from an iterator.

    Args:
        messages: The messages. Only the queue's thread uses the iterator.
        size: The largest number of messages that wait in the queue.
    """

    def __init__(self, messages: Iterator[BagMessage], size: int) -> None:
        self._messages = messages
        self._batch = max(min(_BATCH, size // 2), 1)
        self._queue: queue.Queue[list[BagMessage] | Exception | None] = queue.Queue(
            max(size // self._batch, 1)
        )
        self.largest = 0  #: bytes of the largest message so far
        self._is_over = threading.Event()
        self._is_filled = threading.Event()
        self._thread = threading.Thread(target=self._read, name="zbot bag reader", daemon=True)
        self._thread.start()

    def wait_until_filled(self, timeout_s: float) -> None:
        """Wait until the queue is full or contains all messages, or until the timeout."""
        self._is_filled.wait(timeout_s)

    def __iter__(self) -> Iterator[BagMessage]:
        """Yield the messages. Raise the exception that the iterator raised."""
        while (item := self._queue.get()) is not None:
            if isinstance(item, Exception):
                raise item
            yield from item

    def close(self) -> None:
        """End the thread."""
        self._is_over.set()
        self._thread.join()

    def _read(self) -> None:
        batch: list[BagMessage] = []
        last: list[Exception | None] = [None]
        try:
            for message in self._messages:
                self.largest = max(self.largest, len(message.data))
                batch.append(message)
                if len(batch) >= self._batch or self._queue.empty():
                    if not self._put(batch):
                        return
                    batch = []
        except Exception as error:  # noqa: BLE001 - `__iter__` raises it in the player's thread
            last = [error, None]
        for item in (batch, *last):
            self._put(item)
        self._is_filled.set()

    def _put(self, item: list[BagMessage] | Exception | None) -> bool:
        while not self._is_over.is_set():
            if self._queue.full():
                self._is_filled.set()
            try:
                self._queue.put(item, timeout=_POLL_S)
            except queue.Full:
                continue
            return True
        return False


def in_send_order(messages: Iterator[BagMessage], size: int) -> Iterator[BagMessage]:
    """Yield messages in the order of sending. Their `log_ns` becomes the time of sending.

    The input has the order of recording, and `size` messages are sorted at a time. So a message
    comes too late if it was recorded more than `size` messages after a message that was sent later.
    """
    waiting: list[tuple[int, int, BagMessage]] = []
    for number, message in enumerate(messages):
        heapq.heappush(waiting, (message.publish_ns, number, message))
        if len(waiting) > size:
            yield _first(waiting)
    while waiting:
        yield _first(waiting)


def _first(waiting: list[tuple[int, int, BagMessage]]) -> BagMessage:
    time_ns, _, message = heapq.heappop(waiting)
    return message._replace(log_ns=time_ns)
