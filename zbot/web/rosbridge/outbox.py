"""Queue of the frames and messages that wait for one client.

The size of the queue is limited, so that a slow client cannot fill the memory.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.observer.serving.client_budget import MAX_ANSWER_BYTES, MAX_WAITING_BYTES

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.rosbridge.frame import Frame

#: The largest size of the waiting messages of topics, in bytes before encoding. If there are more,
#: the oldest messages of the topic that received the last message are dropped.
MAX_TOPIC_BYTES = MAX_WAITING_BYTES
#: The largest number of waiting responses, and their largest size in bytes. If there are more, the
#: server disconnects the client, because no response may be dropped.
MAX_REPLIES = 2000
MAX_REPLY_BYTES = MAX_ANSWER_BYTES
#: Length of the queue of a subscription without `queue_length`.
DEFAULT_QUEUE_LENGTH = 100
_BATCH_BYTES = 1_000_000
_BATCH_FRAMES = 64


@dataclass(eq=False)
class TopicQueue:
    """Messages of one subscription that wait for the client.

    If `queue_length` is 0, a message is dropped when less than `period_s` has passed since the last
    kept message. Otherwise messages wait until they are due, and the oldest message is dropped when
    the queue is full.
    """

    encode: Callable[[bytes], list[Frame]]  #: called when the message is sent
    period_s: float = 0.0
    queue_length: int = 0
    dropped: int = 0  #: number of messages that were dropped because the queue was full
    payloads: deque[bytes] = field(default_factory=deque)
    due_s: float = 0.0  #: earliest time of the next message, in seconds of `Outbox`'s clock


@dataclass
class Batch:
    """Frames to send now, and the time of the next batch."""

    frames: list[Frame]
    delay_s: float | None  #: seconds until the next batch; 0 if due now, None if nothing waits


class Outbox:
    """Frames and messages that wait for one client. Any thread may call any method.

    Args:
        wake: A quick function, called when there may be something to send.
        clock: Returns the time in seconds.
    """

    def __init__(
        self, wake: Callable[[], None], clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.is_overrun = False  #: whether too many responses wait; the client is disconnected
        self._wake = wake
        self._clock = clock
        self._lock = threading.Lock()
        self._replies: deque[Frame] = deque()
        self._reply_bytes = 0
        self._topics: deque[TopicQueue] = deque()  # in the order of their turns
        self._topic_bytes = 0

    def reply(self, frames: list[Frame]) -> None:
        """Add frames that must arrive: responses, results and statuses."""
        with self._lock:
            size = sum(map(len, frames))
            is_full = (
                len(self._replies) >= MAX_REPLIES or self._reply_bytes + size > MAX_REPLY_BYTES
            )
            if self._replies and is_full:
                self.is_overrun = True
            else:
                self._replies += frames
                self._reply_bytes += size
        self._wake()

    def add(self, queue: TopicQueue) -> None:
        """Add the queue of a topic."""
        with self._lock:
            self._topics.append(queue)

    def remove(self, queue: TopicQueue) -> None:
        """Remove the queue of a topic. A queue that was removed before is ignored."""
        with self._lock:
            if queue in self._topics:
                self._topics.remove(queue)
                self._topic_bytes -= sum(map(len, queue.payloads))
                queue.payloads.clear()

    def put(self, queue: TopicQueue, payload: bytes) -> None:
        """Add a topic's message. The oldest messages of the topic may be dropped."""
        with self._lock:
            if not self._accepts(queue):
                return
            queue.payloads.append(payload)
            self._topic_bytes += len(payload)
            length = queue.queue_length or DEFAULT_QUEUE_LENGTH
            while queue.payloads and (len(queue.payloads) > length or self._is_too_much(queue)):
                self._topic_bytes -= len(queue.payloads.popleft())
                queue.dropped += 1
        self._wake()

    def _accepts(self, queue: TopicQueue) -> bool:
        if queue not in self._topics:
            return False  # the client has unsubscribed meanwhile
        if queue.period_s and not queue.queue_length:
            now = self._clock()
            if now < queue.due_s:
                return False
            queue.due_s = now + queue.period_s
        return True

    def _is_too_much(self, queue: TopicQueue) -> bool:
        # A message that is larger than the limit may wait alone.
        return self._topic_bytes > max(MAX_TOPIC_BYTES, len(queue.payloads[-1]))

    def take(self) -> Batch:
        """Remove and return frames that are due.

        Responses come first. Then each topic sends one message in turn.
        """
        frames: list[Frame] = []
        size = 0
        while len(frames) < _BATCH_FRAMES and size < _BATCH_BYTES:
            found = self._next()
            if not isinstance(found, list):
                return Batch(frames, found)
            frames += found
            size += sum(map(len, found))
        return Batch(frames, 0.0)

    def _next(self) -> list[Frame] | float | None:
        """Return the next frames, the seconds until frames are due, or None if nothing waits."""
        with self._lock:
            if self._replies:
                frame = self._replies.popleft()
                self._reply_bytes -= len(frame)
                return [frame]
            now = self._clock()
            delays = []
            for queue in tuple(self._topics):
                if not queue.payloads:
                    continue
                delay = queue.due_s - now if queue.queue_length else 0
                if delay > 0:
                    delays.append(delay)
                    continue
                payload = queue.payloads.popleft()
                self._topic_bytes -= len(payload)
                if queue.queue_length:
                    queue.due_s = now + queue.period_s
                self._topics.remove(queue)
                self._topics.append(queue)
                break
            else:
                return min(delays) if delays else None
        return queue.encode(payload)
