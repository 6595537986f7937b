"""Buffer of transforms. It can wait for transforms, and it transforms stamped messages."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from zbot.executor.callback_stack import current_executor
from zbot.executor.task import Future
from zbot.node.argument_check import check_object
from zbot.tf2.buffer_core import BufferCore
from zbot.tf2.buffer_interface import NO_WAIT, BufferInterface, check_timeout
from zbot.tf2.errors import TransformException
from zbot.threads.deadline import Deadline
from zbot.threads.wakeup import LONGEST_WAIT_S

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.node.node import Node
    from zbot.node.service import Service
    from zbot.node.subscription import Subscription
    from zbot.time import Duration

# Seconds between two checks, while a callback waits for messages of its own executor.
_LOOK_S = 0.005


class Buffer(BufferCore, BufferInterface):
    """Buffer of frames and their history.

    Args:
        cache_time: Time for which samples are kept. The default is 10 s.
        node: A node that gets the service `tf2_frames`. The service returns all frames as YAML.

    Raises:
        WrongTypeError: `cache_time` is not a `Duration`.
        ArgumentTypeError: `node` is not a node.
    """

    def __init__(self, cache_time: Duration | None = None, node: Node | None = None) -> None:
        super().__init__(cache_time)
        self.node = node
        if node is not None:
            check_object("node", node, "a node", "create_service")
            self.srv = self._frames_service(node)
        self.subscriptions: list[Subscription[Any]] = []  #: subscriptions of the buffer's listener
        self.is_fed: Callable[[], bool] = lambda: True  #: whether transforms can still arrive
        self._waiting: list[tuple[Callable[[], Any], Future[Any]]] = []
        self._is_in_message = False

    def _frames_service(self, node: Node) -> Service[Any, Any]:
        from tf2_msgs.srv import FrameGraph  # noqa: PLC0415 - few programs give a node

        def frames(_: Any, response: Any) -> Any:
            response.frame_yaml = self.all_frames_as_yaml()
            return response

        return node.create_service(FrameGraph, "tf2_frames", frames)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT
    ) -> Any:
        """Return the transform of `source_frame` in `target_frame`, as `TransformStamped`.

        Args:
            target_frame: The frame of the coordinates.
            source_frame: The frame whose position and orientation are returned.
            time: The time of the transform. `Time()` means the latest time that is known for all
                frames between the two.
            timeout: Longest time to wait until the transform is known. If a callback waits, its
                executor still receives transforms.

        Raises:
            LookupException: A frame does not exist.
            ConnectivityException: The frames are in different trees.
            ExtrapolationException: The time is outside of the known samples.
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
        """Return the transform of `source_frame` in `target_frame`, with a time for each frame.

        The result is the pose of `source_frame` at `source_time`, relative to `target_frame` at
        `target_time`. `fixed_frame` must not move between the two times. The errors are those of
        `lookup_transform`.
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
        """Return whether a lookup succeeds within `timeout`.

        With `return_debug_tuple`, return a tuple of this result and the reason for a failure.
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
        """Return whether `lookup_transform_full` succeeds within `timeout`."""
        ends = (target_frame, target_time, source_frame, source_time, fixed_frame)
        self._wait(lambda: self.can_transform_full_core(*ends)[0], timeout)
        return self.can_transform_full_core(*ends)[0]

    def _wait(self, is_known: Callable[[], bool], timeout: Duration) -> None:
        check_timeout(timeout)
        deadline = Deadline(timeout.nanoseconds / 1e9)
        while not is_known() and self.is_fed():
            if deadline.is_over:
                return
            executor = current_executor()
            own = () if executor is None else self.subscriptions
            if executor is not None and any([executor.serve(each) for each in own]):  # noqa: C419
                continue
            with self._changed:
                self._changed.wait(min(deadline.left_s, _LOOK_S if own else LONGEST_WAIT_S))

    def wait_for_transform_async(
        self, target_frame: str, source_frame: str, time: Any
    ) -> Future[bool]:
        """Return a future whose result becomes True when the transform is known."""

        def known() -> Any:
            return self._is_possible(target_frame, source_frame, time) or None

        return self._later(known)

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """Wait for a transform without a time limit, and return it."""
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
        """Wait without a time limit for the transform of `lookup_transform_full`, and return it."""
        ends = (target_frame, target_time, source_frame, source_time, fixed_frame)
        await self._later(lambda: self.can_transform_full(*ends) or None)
        return self.lookup_transform_full_core(*ends)

    def _later(self, find: Callable[[], Any]) -> Future[Any]:
        future: Future[Any] = Future()
        with self._changed:  # no transform can be set between the lookup and the registration
            found = find()
            if found is None:
                self._waiting.append((find, future))
        if found is not None:
            future.set_result(found)
        return future

    def _set(self, transform: Any, authority: str, *, is_static: bool) -> None:
        super()._set(transform, authority, is_static=is_static)
        if not self._is_in_message:  # otherwise `one_message` notifies at the end of the message
            self._notify_waiting()

    @contextmanager
    def one_message(self) -> Iterator[None]:
        """Notify waiting lookups once at the end of the block, not after each transform."""
        with self._changed:
            self._is_in_message = True
            try:
                yield
            finally:
                self._is_in_message = False
        self._notify_waiting()

    def _notify_waiting(self) -> None:
        for future, found in self._found() if self._waiting else ():
            future.set_result(found)  # without the lock, because this may call callbacks

    def _found(self) -> list[tuple[Future[Any], Any]]:
        """Remove the futures whose transforms are known now. Return them and the transforms."""
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
