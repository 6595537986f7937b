"""A buffer that waits for transforms, and transforms what has a frame and a time."""

from __future__ import annotations

import time as clock
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError
from zbot.executor.callback_stack import current_executor
from zbot.executor.task import Future
from zbot.tf2.buffer_core import BufferCore
from zbot.tf2.buffer_interface import NO_WAIT, BufferInterface
from zbot.tf2.errors import TransformException
from zbot.time import Duration
from zbot.transport.wakeup import LONGEST_WAIT_S

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.node.subscription import Subscription

# While a callback waits for what its own executor would receive, it looks this often.
_LOOK_S = 0.005


class Buffer(BufferCore, BufferInterface):
    """Frames, their history, and waiting for them.

    Args:
        cache_time: How long samples are kept; 10 s if left out.
        node: Accepted as in tf2_ros.
    """

    def __init__(self, cache_time: Duration | None = None, node: Any = None) -> None:
        super().__init__(cache_time)
        self.node = node
        self.subscriptions: list[Subscription[Any]] = []  #: what a listener feeds it from
        self.is_fed: Callable[[], bool] = lambda: True  #: whether anything may still come
        self._waiting: list[tuple[Callable[[], Any], Future[Any]]] = []
        self._is_in_message = False

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT
    ) -> Any:
        """Return where `source_frame` is in `target_frame`, as `TransformStamped`.

        Args:
            target_frame: In whose coordinates.
            source_frame: Whose place.
            time: When; `Time()` is the latest that all frames in between have.
            timeout: How long to wait until it is known. Also in a callback: the transforms that
                its own executor would receive are received meanwhile.

        Raises:
            LookupException: A frame does not exist.
            ConnectivityException: Nothing connects the frames.
            ExtrapolationException: The time lies outside of what is known.
            InvalidArgumentException: A name is empty or begins with a slash.
        """
        self._wait(lambda: self._is_possible(target_frame, source_frame, time), timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return where `source_frame` was at one time, in `target_frame` at another.

        Between the two times only `fixed_frame` stays where it is; see `lookup_transform`.
        """
        ends = (target_frame, target_time, source_frame, source_time, fixed_frame)
        self._wait(lambda: self.can_transform_full(*ends), timeout)
        return self.lookup_transform_full_core(*ends)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Any,
        timeout: Duration = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> bool | tuple[bool, str]:
        """Return whether a lookup succeeds, at the latest after `timeout`.

        With `return_debug_tuple`: and, if not, why.
        """
        self._wait(lambda: self._is_possible(target_frame, source_frame, time), timeout)
        answer = self.can_transform_core(target_frame, source_frame, time)
        return answer if return_debug_tuple else answer[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> bool:
        """Return whether `lookup_transform_full` succeeds, at the latest after `timeout`."""
        ends = (target_frame, target_time, source_frame, source_time, fixed_frame)
        self._wait(lambda: self.can_transform_full_core(*ends)[0], timeout)
        return self.can_transform_full_core(*ends)[0]

    def _wait(self, is_known: Callable[[], bool], timeout: Duration) -> None:
        if not isinstance(timeout, Duration):
            raise ArgumentTypeError("timeout", "a Duration", timeout)
        deadline = clock.monotonic() + timeout.nanoseconds / 1e9
        while not is_known() and self.is_fed():
            left = deadline - clock.monotonic()
            if left <= 0:
                return
            executor = current_executor()
            own = () if executor is None else self.subscriptions
            if executor is not None and any([executor.serve(each) for each in own]):  # noqa: C419
                continue
            with self._changed:
                self._changed.wait(min(left, _LOOK_S if own else LONGEST_WAIT_S))

    # -- for coroutines ------------------------------------------------------------------------

    def wait_for_transform_async(
        self, target_frame: str, source_frame: str, time: Any
    ) -> Future[bool]:
        """Return a future that is done with True when the transform is known."""

        def known() -> Any:
            return self._is_possible(target_frame, source_frame, time) or None

        return self._later(known)

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """Wait as long as it takes for a transform, and return it."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_full_async(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
    ) -> Any:
        """Wait as long as it takes for a transform between two times, and return it."""
        ends = (target_frame, target_time, source_frame, source_time, fixed_frame)
        await self._later(lambda: self.can_transform_full(*ends) or None)
        return self.lookup_transform_full_core(*ends)

    def _later(self, find: Callable[[], Any]) -> Future[Any]:
        future: Future[Any] = Future()
        with self._changed:  # nothing may arrive between the look and the wait
            found = find()
            if found is None:
                self._waiting.append((find, future))
        if found is not None:
            future.set_result(found)
        return future

    def _set(self, transform: Any, authority: str, *, is_static: bool) -> None:
        super()._set(transform, authority, is_static=is_static)
        if not self._is_in_message:  # otherwise at the message's end
            self._tell_waiting()

    @contextmanager
    def one_message(self) -> Iterator[None]:
        """Let those who wait look once when the block ends, not after each transform it sets."""
        with self._changed:
            self._is_in_message = True
            try:
                yield
            finally:
                self._is_in_message = False
        self._tell_waiting()

    def _tell_waiting(self) -> None:
        for future, found in self._found() if self._waiting else ():
            future.set_result(found)  # without the lock: it may call anything

    def _found(self) -> list[tuple[Future[Any], Any]]:
        """Return the futures whose transforms are known by now, and wait for them no more."""
        complete, waiting = [], []
        with self._changed:
            for find, future in self._waiting:
                if future.is_over:
                    continue
                found = find()
                if found is None:
                    waiting.append((find, future))
                else:
                    complete.append((future, found))
            self._waiting = waiting
        return complete


__all__ = ["Buffer", "TransformException"]
