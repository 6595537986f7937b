"""Buffer for other nodes: server and client of the action `tf2_msgs/LookupTransform`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.action.client import ActionClient
from zbot.action.server import ActionServer
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.tf2.buffer_core import check_time
from zbot.tf2.buffer_interface import NO_WAIT, BufferInterface, check_timeout
from zbot.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from zbot.time import Duration, Time

from builtin_interfaces.msg import Time as Stamp
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TF2Error

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.tf2.buffer import Buffer

_CODES: dict[int, type[TransformException]] = {
    TF2Error.LOOKUP_ERROR: LookupException,
    TF2Error.CONNECTIVITY_ERROR: ConnectivityException,
    TF2Error.EXTRAPOLATION_ERROR: ExtrapolationException,
    TF2Error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
    TF2Error.TIMEOUT_ERROR: TimeoutException,
    TF2Error.TRANSFORM_ERROR: TransformException,
}
_PADDING = Duration(seconds=2.0)  # the default in tf2_ros


class BufferServer:
    """Action server that looks transforms up in a buffer.

    Args:
        buffer: The buffer.
        node: The node that has the action. The node's executor runs the callbacks.
        ns: The action's name.
    """

    def __init__(self, buffer: Buffer, node: Node, ns: str = "tf2_buffer_server") -> None:
        self._buffer = buffer
        self._server = ActionServer(
            node, LookupTransform, ns, self._execute, callback_group=ReentrantCallbackGroup()
        )

    def _execute(self, goal_handle: Any) -> Any:
        result = LookupTransform.Result()
        try:
            result.transform = self._look_up(goal_handle.request)
        except TransformException as error:
            codes = (code for code, kind in _CODES.items() if isinstance(error, kind))
            result.error = TF2Error(error=next(codes), error_string=str(error))
        goal_handle.succeed()
        return result

    def _look_up(self, goal: Any) -> Any:
        timeout, when = Duration.from_msg(goal.timeout), Time.from_msg(goal.source_time)
        if not goal.advanced:
            return self._buffer.lookup_transform(
                goal.target_frame, goal.source_frame, when, timeout
            )
        then = Time.from_msg(goal.target_time)
        return self._buffer.lookup_transform_full(
            goal.target_frame, then, goal.source_frame, when, goal.fixed_frame, timeout
        )

    def destroy(self) -> None:
        """Destroy the action server."""
        self._server.destroy()


class BufferClient(BufferInterface):
    """Client that looks transforms up in another node's buffer.

    Args:
        node: The client's node. Lookups need no executor, so a callback may make lookups too.
        ns: The action's name.
        check_frequency: Accepted without effect, because nothing is polled.
        timeout_padding: Time to wait for the server in addition to a lookup's timeout, as a
            `Duration` or in seconds.
    """

    def __init__(
        self,
        node: Node,
        ns: str,
        check_frequency: float = 10.0,
        timeout_padding: Duration | float = _PADDING,
    ) -> None:
        self._client: ActionClient[Any, Any, Any] = ActionClient(node, LookupTransform, ns)
        self._name = ns
        if not isinstance(timeout_padding, Duration):
            timeout_padding = Duration(seconds=timeout_padding)
        self._padding = timeout_padding

    def wait_for_server(self, timeout: Duration = NO_WAIT) -> bool:
        """Wait for a server. Return whether it appeared within `timeout`."""
        check_timeout(timeout)
        return self._client.wait_for_server(timeout.nanoseconds / 1e9)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT
    ) -> Any:
        """Return the transform of `source_frame` in `target_frame`, as `TransformStamped`.

        Raises:
            TimeoutException: The action has no server.
            TransformException: The lookup in the server's buffer failed with this error.
        """
        return self._ask(
            timeout,
            target_frame=target_frame,
            source_frame=source_frame,
            source_time=_stamp(time),
        )

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

        See `Buffer.lookup_transform_full`. The errors are those of `lookup_transform`.
        """
        return self._ask(
            timeout,
            target_frame=target_frame,
            target_time=_stamp(target_time),
            source_frame=source_frame,
            source_time=_stamp(source_time),
            fixed_frame=fixed_frame,
            advanced=True,
        )

    def can_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT
    ) -> bool:
        """Return whether `lookup_transform` succeeds."""
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
        except TransformException:
            return False
        return True

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> bool:
        """Return whether `lookup_transform_full` succeeds."""
        try:
            self.lookup_transform_full(
                target_frame, target_time, source_frame, source_time, fixed_frame, timeout
            )
        except TransformException:
            return False
        return True

    def _ask(self, timeout: Duration, **question: Any) -> Any:
        check_timeout(timeout)
        patience = (timeout + self._padding).nanoseconds / 1e9
        if not self._client.wait_for_goal_service(patience):
            raise TimeoutException(f"no node serves the action {self._name}")
        goal = LookupTransform.Goal(timeout=timeout.to_msg(), **question)
        result = self._client.send_goal(goal).result
        kind = _CODES.get(result.error.error)
        if kind is not None:
            raise kind(result.error.error_string)
        return result.transform

    def destroy(self) -> None:
        """Destroy the action client."""
        self._client.destroy()


def _stamp(time: Any) -> Any:
    check_time(time)
    return time if isinstance(time, Stamp) else time.to_msg()
