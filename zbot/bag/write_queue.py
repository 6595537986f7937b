"""Queue of messages for a bag, and the thread that writes them."""

from __future__ import annotations

import enum
import queue
import threading
import traceback
from collections import deque
from typing import TYPE_CHECKING

from zbot.bag.errors import BagWriteError
from zbot.bag.message import BagMessage
from zbot.errors import ZbotError
from zbot.log import get_logger
from zbot.threads.deadline import Deadline
from zbot.time import S_TO_NS

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.bag.message import Definition
    from zbot.bag.metadata import TopicMetadata
    from zbot.bag.writer import Writer

LOST_KEY = "lost_messages"  #: key in the metadata of a bag that has lost messages
FLUSH_S = 0.5  #: period of `flush`; messages before it survive a crash of the process


class _Order(enum.Enum):
    """Orders for the thread that writes."""

    SPLIT = enum.auto()
    END = enum.auto()


class WriteQueue:
    """Queue that decouples the receiving thread from the disk.

    Only one thread may call `add_topic`, `put` and `put_all`.

    Args:
        writer: The bag. From now on, only the queue's thread uses it.
        max_bytes: Bytes of the messages that may wait. 0 means no limit.
    """

    def __init__(self, writer: Writer, max_bytes: int) -> None:
        self.error: ZbotError | None = None  #: why nothing can be written any more
        self._writer = writer
        self._max_bytes = max_bytes
        self._items: queue.SimpleQueue[BagMessage | tuple[TopicMetadata, Definition] | _Order] = (
            queue.SimpleQueue()
        )
        # Only one thread changes each of these numbers, so they need no lock.
        self._put_bytes = self._written_bytes = 0
        self._thread = threading.Thread(target=self._run, name="zbot bag", daemon=True)
        self._thread.start()

    def add_topic(self, topic: TopicMetadata, definition: Definition) -> None:
        """Add a topic to the bag."""
        self._items.put((topic, definition))

    def put(self, message: BagMessage) -> bool:
        """Add a message. Return false if the queue is full, so that the message is lost."""
        size = len(message.data)
        waiting = self._put_bytes - self._written_bytes
        if self._max_bytes and waiting and waiting + size > self._max_bytes:
            return False
        self._put_bytes += size
        self._items.put(message)
        return True

    def put_all(self, messages: Iterable[BagMessage]) -> None:
        """Add messages without the limit `max_bytes`."""
        for message in messages:
            self._put_bytes += len(message.data)
            self._items.put(message)

    def split(self) -> None:
        """Begin the next file of the bag when the waiting messages are written."""
        self._items.put(_Order.SPLIT)

    def close(self, lost: str = "") -> None:
        """Write all messages, and close the bag.

        Args:
            lost: Text about lost messages for the bag's metadata.

        Raises:
            BagWriteError: The bag cannot be written, e.g. because the disk is full.
        """
        self._items.put(_Order.END)
        self._thread.join()
        if lost:
            self._writer.set_custom_data(LOST_KEY, lost)
        try:
            self._writer.close()
        finally:
            if self.error is not None:  # the first error is the reason, and `close` may fail too
                raise self.error

    def _run(self) -> None:
        try:
            self._write_all()
        except ZbotError as error:
            self.error = error
        except Exception as error:  # noqa: BLE001 - the recorder reads `error`
            self.error = BagWriteError(self._writer.path, repr(error))
            get_logger("zbot.bag").error("".join(traceback.format_exception(error)))

    def _write_all(self) -> None:
        due = Deadline(FLUSH_S)
        while True:
            if due.is_over:
                self._writer.flush()
                due = Deadline(FLUSH_S)
                continue
            try:
                item = self._items.get(timeout=due.left_s)
            except queue.Empty:
                continue
            if item is _Order.END:
                return
            if isinstance(item, BagMessage):
                self._written_bytes += len(item.data)
                self._writer.write_serialized(*item)
            elif isinstance(item, tuple):
                self._writer.create_topic(*item)
            else:
                self._writer.split()


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
