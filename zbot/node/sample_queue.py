"""Queue of a subscription's samples, which takes them from Zenoh's queue.

Zenoh puts samples into its own queue, without Python. While samples are rare, a second Zenoh
subscriber of the key, the notifier, tells the executor of each sample: Zenoh's network thread calls
its function. So a sample wakes one thread, and an idle subscription needs no thread. Each call of
the notifier takes Python's lock. So when samples come quickly, the notifier is undeclared, and the
executor's thread looks into Zenoh's queue itself. When that queue stays empty for a moment, the
notifier is declared again. docs/design/receiving.md compares this with other ways.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections import deque
from itertools import islice
from typing import TYPE_CHECKING, Any, Protocol

import zenoh

from zbot.threads.foreign_call import called_by_zenoh, keep_thread_state
from zbot.threads.wakeup import LARGE_MESSAGE_WAIT_NS, BusyWait

if TYPE_CHECKING:
    from collections.abc import Callable

# Zenoh may call the notifier a moment before it puts the sample into its queue, and on a busy
# machine its thread may stop in between. So a queue that is empty after a call is looked at again
# after these times.
_LATE_NS = (1_000_000, 10_000_000, 100_000_000, 1_000_000_000)


class Channel(Protocol):
    """Zenoh's queue. The method raises a `ZError` after it was undeclared."""

    def try_recv(self) -> zenoh.Sample | None:
        """Return a sample if there is one."""
        ...


class LatchedChannel:
    """Queue like Zenoh's, which also tells the executor of each sample.

    A transient local subscription has one, because only the handler of its own Zenoh subscriber
    gets the past samples. So no second subscriber can tell of these.

    Args:
        depth: How many samples to keep.
        blocks: Whether `receive` waits while the queue is full, which blocks the publishers.
            Otherwise the oldest sample is dropped.
    """

    def __init__(self, depth: int, *, blocks: bool) -> None:
        self._samples: deque[zenoh.Sample] = deque(maxlen=None if blocks else depth)
        self._room = threading.Semaphore(depth) if blocks else None
        #: Tells the executor that there is a sample.
        self.post: Callable[[], object] = bool

    def receive(self, sample: zenoh.Sample) -> None:
        """Add a sample. A thread of Zenoh calls this."""
        if (room := self._room) is not None:  # another thread may end the queue meanwhile
            room.acquire()
        self._samples.append(sample)
        self.post()

    def try_recv(self) -> zenoh.Sample | None:
        """Remove and return the oldest sample, if any."""
        try:
            sample = self._samples.popleft()
        except IndexError:
            return None
        if (room := self._room) is not None:
            room.release()
        return sample

    def end(self) -> None:
        """Never wait from now on."""
        self.post = bool
        if self._room is not None:
            room, self._room = self._room, None
            room.release()


class SampleQueue:
    """Samples that a subscription has received. Only the executor's thread may take them.

    Args:
        channel: Zenoh's queue.
        depth: How many samples to keep. The oldest samples are dropped. `None` keeps all.
        batch: The largest number of samples to move in one call. Without a limit, a publisher that
            never pauses would keep the call from returning.
        post: Tells the executor that there may be a sample.
        declare: Declares the notifier with a handler. `None`: the channel itself calls `post`.
    """

    def __init__(
        self,
        channel: Channel,
        *,
        depth: int | None,
        batch: int,
        post: Callable[[], object],
        declare: Callable[[Any], Any] | None = None,
    ) -> None:
        self.next_sample = channel.try_recv  #: takes a sample from Zenoh's queue
        self.due_ns: int | None = None  #: when to look into Zenoh's queue without a post
        self._samples: deque[zenoh.Sample] = deque(maxlen=depth)
        self._keeps_all = depth is None
        self._batch = batch
        self._post = post
        self._declare = declare
        self._notifier: Any = None
        self._switching = threading.Lock()
        self._was_told = False  # whether the notifier has told of a sample since the last `take`
        self._was_told_of_more = False  # whether it told of several before one `take`
        self._is_waiting = False
        self._late = iter(_LATE_NS)
        self._busy_wait = BusyWait()

    def start(self) -> None:
        """Let the notifier tell the executor of samples, also of those that have come already."""
        self._begin_notifier()
        self._post()

    @property
    def is_watched(self) -> bool:
        """Whether the executor's thread looks into Zenoh's queue, because samples come quickly."""
        return self._notifier is None and self._declare is not None

    @called_by_zenoh
    def _tell(self, _: zenoh.Sample) -> None:
        keep_thread_state()
        if self._was_told:
            self._was_told_of_more = True
            # The executor's thread is busy, and looks into Zenoh's queue later. If that thread is
            # just changing the notifier, it must not be waited for.
            if self._switching.acquire(blocking=False):
                try:
                    self._undeclare_notifier()
                finally:
                    self._switching.release()
        # Meanwhile, the executor's thread may have looked into Zenoh's queue and gone to sleep.
        self._was_told = True
        self._post()

    def take(self) -> zenoh.Sample | None:
        """Remove and return the oldest sample, if any."""
        samples = self._samples
        # With keep-last, each call moves all new samples from Zenoh's queue to this queue, so that
        # this queue drops the oldest samples. With keep-all, samples are moved only when this queue
        # is empty. A blocked publisher wakes up each time that Zenoh's full queue gets room. So
        # there are few wake-ups if many samples are moved in one call.
        if not (samples and self._keeps_all):
            was_told, self._was_told = self._was_told, False
            try:
                self._move()
                if not samples:
                    self._wait(was_told)
                elif self._is_waiting:
                    self._is_waiting = False
                    self._busy_wait.end(came=True)
            except zenoh.ZError:
                self.due_ns = None
                return None  # another thread destroyed the subscription or closed the session
        try:
            return samples.popleft()
        except IndexError:
            return None

    def _move(self) -> None:
        # This loop runs in C.
        self._samples.extend(islice(iter(self.next_sample, None), self._batch))

    def __bool__(self) -> bool:
        """Return whether there is a sample. Only the thread that calls `take` may ask this."""
        if not self._samples:
            sample = self.take()
            if sample is not None:
                self._samples.appendleft(sample)
        return bool(self._samples)

    def expect_large(self) -> None:
        """Let the next waits be those for large messages, whose round trips take longer."""
        self._busy_wait.short_wait_ns = LARGE_MESSAGE_WAIT_NS

    def _wait(self, was_told: bool) -> None:
        """Let the notifier wait for the next sample, after a moment in which none has come."""
        if self._busy_wait.begin(self._fetch):
            self._end_notifier()
            return
        if self.is_watched:
            self._begin_notifier()
            self._move()  # a sample that came before the notifier
            if self._samples:
                return
            was_told = True  # Zenoh may have a sample that it does not tell the new notifier of
        self._is_waiting = True
        if was_told or self._was_told_of_more:
            self._was_told_of_more = False
            self._late = iter(_LATE_NS)
        elif self.due_ns is None:
            return
        pause_ns = next(self._late, None)
        self.due_ns = None if pause_ns is None else time.monotonic_ns() + pause_ns

    def _fetch(self) -> bool:
        sample = self.next_sample()
        if sample is None:
            return False
        self._samples.append(sample)
        return True

    def _begin_notifier(self) -> None:
        with self._switching:
            if self._declare is not None and self._notifier is None:
                tell: Any = zenoh.handlers.Callback(self._tell, indirect=False)
                self._notifier = self._declare(tell)

    def _end_notifier(self) -> None:
        with self._switching:
            self._undeclare_notifier()

    def _undeclare_notifier(self) -> None:
        notifier, self._notifier = self._notifier, None
        if notifier is not None:
            notifier.undeclare()

    def end(self) -> None:
        """End the notifier. Zenoh's queue must be gone, or must be so soon."""
        self._post = bool  # the subscription and the queue no longer refer to each other
        with contextlib.suppress(zenoh.ZError), self._switching:  # the session may be closed
            self._declare = None
            self._undeclare_notifier()
