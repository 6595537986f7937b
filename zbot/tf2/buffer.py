"""A buffer that waits for transforms, and transforms what has a frame and a time."""

from __future__ import annotations

import time as clock
from typing import TYPE_CHECKING, Any

from zbot.executor import current_executor
from zbot.task import Future
from zbot.tf2 import conversion
from zbot.tf2.buffer_core import BufferCore
from zbot.tf2.errors import TransformException
from zbot.time import Duration, Time

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.subscription import Subscription

# While a callback waits for what its own executor would receive, it looks this often.
_LOOK_S = 0.005
_NO_WAIT = Duration()


class Buffer(BufferCore):
    """Frames, their history, and waiting for them.

    Args:
        cache_time: How long samples are kept; 10 s if left out.
        node: Accepted as in tf2_ros.
    """

    def __init__(self, cache_time: Duration | None = None, node: Any = None) -> None:
        super().__init__(cache_time)
        self.node = node
        self.subscriptions: list[Subscription[Any]] = []  #: what a listener feeds it from
        self._waiting: list[tuple[Callable[[], Any], Future[Any]]] = []

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = _NO_WAIT
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
        self._wait(lambda: self.can_transform_core(target_frame, source_frame, time)[0], timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = _NO_WAIT,
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
        timeout: Duration = _NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> bool | tuple[bool, str]:
        """Return whether a lookup succeeds, at the latest after `timeout`.

        With `return_debug_tuple`: and, if not, why.
        """
        self._wait(lambda: self.can_transform_core(target_frame, source_frame, time)[0], timeout)
        answer = self.can_transform_core(target_frame, source_frame, time)
        return answer if return_debug_tuple else answer[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = _NO_WAIT,
    ) -> bool:
        """Return whether `lookup_transform_full` succeeds, at the latest after `timeout`."""

        def is_known() -> bool:
            return (
                self.can_transform_core(fixed_frame, source_frame, source_time)[0]
                and self.can_transform_core(target_frame, fixed_frame, target_time)[0]
            )

        self._wait(is_known, timeout)
        return is_known()

    def _wait(self, is_known: Callable[[], bool], timeout: Duration) -> None:
        deadline = clock.monotonic() + timeout.nanoseconds / 1e9
        while not is_known():
            left = deadline - clock.monotonic()
            if left <= 0:
                return
            executor = current_executor()
            own = () if executor is None else self.subscriptions
            if executor is not None and any([executor.serve(each) for each in own]):  # noqa: C419
                continue
            with self._changed:
                self._changed.wait(min(left, _LOOK_S) if own else left)

    # -- for coroutines ------------------------------------------------------------------------

    def wait_for_transform_async(
        self, target_frame: str, source_frame: str, time: Any
    ) -> Future[bool]:
        """Return a future that is done with True when the transform is known."""

        def known() -> Any:
            return self.can_transform_core(target_frame, source_frame, time)[0] or None

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
        found = find()
        if found is not None:
            future.set_result(found)
        else:
            self._waiting.append((find, future))
        return future

    def _set(self, transform: Any, authority: str, *, is_static: bool) -> bool:
        is_kept = super()._set(transform, authority, is_static=is_static)
        for entry in list(self._waiting):
            find, future = entry
            found = None if future.is_over else find()
            if found is not None:
                future.set_result(found)
            if future.is_over:
                self._waiting.remove(entry)
        return is_kept

    # -- objects -------------------------------------------------------------------------------

    def transform(
        self,
        object_stamped: Any,
        target_frame: str,
        timeout: Duration = _NO_WAIT,
        new_type: type[Any] | None = None,  # noqa: ARG002 - tf2_ros' signature
    ) -> Any:
        """Return a point, vector or pose with header, in another frame.

        Raises:
            TypeException: Nobody knows how to transform objects of its class.
            TransformException: For the other errors see `lookup_transform`.
        """
        do_transform = conversion.registered(type(object_stamped))
        header = object_stamped.header
        when = Time.from_msg(header.stamp)
        found = self.lookup_transform(target_frame, header.frame_id, when, timeout)
        return do_transform(object_stamped, found)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Any,
        fixed_frame: str,
        timeout: Duration = _NO_WAIT,
    ) -> Any:
        """Return a point, vector or pose with header, in another frame at another time."""
        do_transform = conversion.registered(type(object_stamped))
        header = object_stamped.header
        when = Time.from_msg(header.stamp)
        found = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, when, fixed_frame, timeout
        )
        return do_transform(object_stamped, found)


__all__ = ["Buffer", "TransformException"]
