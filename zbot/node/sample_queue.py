"""Queue of a subscription's samples, which takes them from Zenoh's queue.

The queue's thread waits for the first sample of a burst. The thread appends the sample to the
queue, and tells the executor. After that, the executor's thread takes the samples from Zenoh's
queue itself. When Zenoh's queue stays empty for a moment, the executor's thread lets the queue's
thread wait again. So a burst costs one wake-up, the two threads never compete, and an idle
subscription uses no CPU.
"""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from itertools import islice
from typing import TYPE_CHECKING, Protocol

import zenoh

from zbot.threads.wakeup import LARGE_MESSAGE_WAIT_NS, BusyWait

if TYPE_CHECKING:
    from collections.abc import Callable


class Channel(Protocol):
    """Zenoh's queue. Both methods raise a `ZError` after it was undeclared."""

    def recv(self) -> zenoh.Sample:
        """Wait for a sample."""
        ...

    def try_recv(self) -> zenoh.Sample | None:
        """Return a sample if there is one."""
        ...


class SampleQueue:
    """Samples that a subscription has received. Only the executor's thread may take them.

    Args:
        channel: Zenoh's queue.
        depth: How many samples to keep. The oldest samples are dropped. `None` keeps all.
        batch: The largest number of samples to move in one call. Without a limit, a publisher that
            never pauses would keep the call from returning.
        post: Tells the executor that there may be a sample.
    """

    def __init__(
        self, channel: Channel, *, depth: int | None, batch: int, post: Callable[[], object]
    ) -> None:
        self.next_sample = channel.try_recv  #: takes a sample from Zenoh's queue
        self._receive = channel.recv
        self._samples: deque[zenoh.Sample] = deque(maxlen=depth)
        self._keeps_all = depth is None
        self._batch = batch
        self._post = post
        self._armed = threading.Lock()  # held while the executor's thread watches Zenoh's queue
        self._armed.acquire()
        self.is_watched = False  #: whether the executor's thread takes from Zenoh's queue itself
        self._busy_wait = BusyWait()
        self._is_over = False

    def listen(self) -> None:
        """Wait for samples until `end` is called or Zenoh's queue is gone. A thread runs this."""
        while True:
            try:
                sample = self._receive()
            except zenoh.ZError:
                return  # undeclared, or the session was closed
            self._busy_wait.end(came=True)
            self._samples.append(sample)
            self.is_watched = True
            self._post()
            if not self._is_over:
                self._armed.acquire()
            if self._is_over:
                return

    def take(self) -> zenoh.Sample | None:
        """Remove and return the oldest sample, if any."""
        samples = self._samples
        # With keep-last, each call moves all new samples from Zenoh's queue to this queue, so that
        # this queue drops the oldest samples. With keep-all, samples are moved only when this queue
        # is empty. A blocked publisher wakes up each time that Zenoh's full queue gets room. So
        # there are few wake-ups if many samples are moved in one call.
        if self.is_watched and not (samples and self._keeps_all):
            try:
                # This loop runs in C.
                samples.extend(islice(iter(self.next_sample, None), self._batch))
                if not (samples or self._busy_wait.begin(self._fetch)):
                    self._rearm()
            except zenoh.ZError:
                return None  # another thread destroyed the subscription or closed the session
        try:
            return samples.popleft()
        except IndexError:
            return None

    def __bool__(self) -> bool:
        """Return whether there is a sample. Only the thread that calls `take` may ask this."""
        if not self._samples and self.is_watched:
            sample = self.take()  # from Zenoh's queue, which the queue's thread does not watch now
            if sample is not None:
                self._samples.appendleft(sample)
        return bool(self._samples)

    def expect_large(self) -> None:
        """Let the next waits be those for large messages, whose round trips take longer."""
        self._busy_wait.short_wait_ns = LARGE_MESSAGE_WAIT_NS

    def _fetch(self) -> bool:
        sample = self.next_sample()
        if sample is None:
            return False
        self._samples.append(sample)
        return True

    def _rearm(self) -> None:
        self.is_watched = False
        with contextlib.suppress(RuntimeError):  # another thread released it first
            self._armed.release()

    def end(self) -> None:
        """End the thread that listens. Zenoh's queue must be gone, or must be so soon."""
        self._is_over = True
        self._post = bool  # the subscription and the queue no longer refer to each other
        self._rearm()
