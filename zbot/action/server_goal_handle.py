"""Handle of a goal for an action server."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from zbot.action.endpoint import ActionGeneric, FeedbackT, GoalT, ResultT
from zbot.action.goal_state import GoalEvent, GoalState, next_state
from zbot.executor.task import Future
from zbot.time import S_TO_NS

from action_msgs.msg import GoalInfo, GoalStatus

if TYPE_CHECKING:
    import threading
    from collections.abc import Callable

    from unique_identifier_msgs.msg import UUID


class GoalServer(Protocol):
    """The part of an action server that a goal uses."""

    lock: threading.RLock  #: held while a goal's state changes and is published

    def notify_execute(self, goal_handle: Any, execute_callback: Callable[..., Any] | None) -> None:
        """Let the executor run a goal."""
        ...

    def publish_feedback(self, handle: Any, feedback: Any) -> None:
        """Publish feedback of a goal."""
        ...

    def publish_status(self) -> None:
        """Publish the states of all goals."""
        ...

    def check_result(self, result: object) -> None:
        """Raise an `ActionMessageError` if an object is not a result of the action."""
        ...

    def deliver(self, handle: Any, result: Any) -> None:
        """Send a goal's result to present and later requests."""
        ...


class ServerGoalHandle(ActionGeneric[GoalT, ResultT, FeedbackT]):
    """A goal that a server accepted. Its methods execute the goal, publish feedback, and end it.

    `ActionServer` makes the handle. All methods may be called from any thread.

    Args:
        action_server: The server that accepted the goal.
        goal_info: The goal's id, and the time at which it was accepted.
        goal_request: The goal, of the action's `Goal` class.
    """

    def __init__(
        self,
        action_server: GoalServer,
        goal_info: GoalInfo,
        goal_request: GoalT,
    ) -> None:
        self._action_server = action_server
        self._goal_request = goal_request
        self._status = GoalStatus(goal_info=goal_info, status=GoalState.ACCEPTED.value)
        self._is_destroyed = False
        self.key = bytes(goal_info.goal_id.uuid)  #: the goal's id as bytes
        self.stamp_ns = goal_info.stamp.sec * S_TO_NS + goal_info.stamp.nanosec
        self.is_started = False  #: whether `execute` was called
        self.result_future: Future[Any] = Future()  #: the response to requests for the result

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

    def __repr__(self) -> str:
        return f"ServerGoalHandle <id={self.key.hex()}, status={self.state.name}>"

    @property
    def request(self) -> GoalT:
        """The goal, of the action's `Goal` class."""
        return self._goal_request

    @property
    def goal_id(self) -> UUID:
        """The goal's id, which the client has made."""
        return self._status.goal_info.goal_id

    @property
    def goal_info(self) -> GoalInfo:
        """The goal's id, and the time at which it was accepted."""
        return self._status.goal_info

    @property
    def status_message(self) -> GoalStatus:
        """The goal's id and state, as in the messages of the status topic."""
        return self._status

    @property
    def state(self) -> GoalState:
        """The goal's state. It is `UNKNOWN` after the server has forgotten the goal."""
        return GoalState.UNKNOWN if self._is_destroyed else GoalState(self._status.status)

    @property
    def status(self) -> int:
        """The number of the goal's state, as in `action_msgs/msg/GoalStatus`."""
        return int(self.state)

    @property
    def is_active(self) -> bool:
        """Whether the goal has not ended."""
        return self.state.is_active

    @property
    def is_cancel_requested(self) -> bool:
        """Whether a cancel request was accepted. The callback should soon call `canceled()`."""
        return self.state is GoalState.CANCELING

    def execute(
        self,
        execute_callback: Callable[[ServerGoalHandle[GoalT, ResultT, FeedbackT]], Any]
        | None = None,
    ) -> None:
        """Let the executor run the goal.

        Args:
            execute_callback: Executes this goal instead of the server's callback.

        Raises:
            GoalTransitionError: The goal is being executed already, or it has ended.
        """
        # A goal that is being canceled is executed too, because the callback must end the goal. A
        # cancel request in another thread may come between the question and the change.
        with self._action_server.lock:
            if not self.is_cancel_requested:
                self.update(GoalEvent.EXECUTE)
        self.is_started = True
        self._action_server.notify_execute(self, execute_callback)

    def executing(self) -> None:
        """Set the state to EXECUTING. A program that does not use `execute` calls this.

        Raises:
            GoalTransitionError: The goal is being executed already, or it has ended.
        """
        self.update(GoalEvent.EXECUTE)

    def publish_feedback(self, feedback: FeedbackT) -> None:
        """Publish feedback for the client.

        Raises:
            ActionMessageError: `feedback` is not of the action's `Feedback` class.
        """
        if not self._is_destroyed:
            self._action_server.publish_feedback(self, feedback)

    def succeed(self, response: ResultT | None = None) -> None:
        """End the goal as SUCCEEDED.

        Args:
            response: The result, which is sent immediately. If left out, the callback's result is
                sent.

        Raises:
            GoalTransitionError: The goal is not being executed.
            ActionMessageError: `response` is not of the action's `Result` class.
        """
        self._end(GoalEvent.SUCCEED, response)

    def abort(self, response: ResultT | None = None) -> None:
        """End the goal as ABORTED (see `succeed`)."""
        self._end(GoalEvent.ABORT, response)

    def canceled(self, response: ResultT | None = None) -> None:
        """End the goal as CANCELED, after a cancel request (see `succeed`)."""
        self._end(GoalEvent.CANCELED, response)

    def _end(self, event: GoalEvent, result: ResultT | None) -> None:
        if result is not None:
            self._action_server.check_result(result)
        self.update(event)
        if result is not None or not self.is_started:
            self.deliver(result)  # otherwise, the callback's result is sent later

    def update(self, event: GoalEvent) -> None:
        """Change the goal's state and publish it. Do nothing if the server has forgotten the goal.

        Raises:
            GoalTransitionError: The state does not allow the event.
        """
        with self._action_server.lock:
            if self._is_destroyed:
                return
            self._status.status = next_state(self.state, event).value
            self._action_server.publish_status()

    def deliver(self, result: ResultT | None) -> None:
        """Send the result to present and later requests. Calls after the first call do nothing."""
        if not self.result_future.is_over and not self._is_destroyed:
            self._action_server.deliver(self, result)

    def destroy(self) -> None:
        """Forget the goal. The methods have no effect after this."""
        self._is_destroyed = True
