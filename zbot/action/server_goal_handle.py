"""A goal as its server sees it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.action.generic import ActionGeneric, FeedbackT, GoalT, ResultT
from zbot.action.goal_state import GoalEvent, GoalState, next_state
from zbot.executor.task import Future
from zbot.time import S_TO_NS

from action_msgs.msg import GoalInfo, GoalStatus

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.action.server import ActionServer

    from unique_identifier_msgs.msg import UUID


class ServerGoalHandle(ActionGeneric[GoalT, ResultT, FeedbackT]):
    """What a server does with one goal: run it, tell how it goes, end it.

    Made by `ActionServer`; all methods may be called from any thread.

    Args:
        action_server: The server that accepted the goal.
        goal_info: The goal's id and when it was accepted.
        goal_request: What is to be reached.
    """

    def __init__(
        self,
        action_server: ActionServer[GoalT, ResultT, FeedbackT],
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
        self.result_future: Future[Any] = Future()  #: the response to whoever asks for the result

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

    def __repr__(self) -> str:
        return f"ServerGoalHandle <id={self.key.hex()}, status={self.state.name}>"

    @property
    def request(self) -> GoalT:
        """The goal: what is to be reached."""
        return self._goal_request

    @property
    def goal_id(self) -> UUID:
        """The goal's id, made by the client."""
        return self._status.goal_info.goal_id

    @property
    def goal_info(self) -> GoalInfo:
        """The goal's id and when it was accepted."""
        return self._status.goal_info

    @property
    def status_message(self) -> GoalStatus:
        """Where the goal stands, as the status topic tells it."""
        return self._status

    @property
    def state(self) -> GoalState:
        """Where the goal stands; `UNKNOWN` once its server has forgotten it."""
        return GoalState.UNKNOWN if self._is_destroyed else GoalState(self._status.status)

    @property
    def status(self) -> int:
        """The number of its state, as in `action_msgs/msg/GoalStatus`."""
        return int(self.state)

    @property
    def is_active(self) -> bool:
        """Whether the goal has not ended."""
        return self.state.is_active

    @property
    def is_cancel_requested(self) -> bool:
        """Whether the goal is to be canceled: end soon, with `canceled()`."""
        return self.state is GoalState.CANCELING

    def execute(
        self,
        execute_callback: Callable[[ServerGoalHandle[GoalT, ResultT, FeedbackT]], Any]
        | None = None,
    ) -> None:
        """Let the executor run the goal.

        Args:
            execute_callback: Runs this goal in place of the server's.

        Raises:
            GoalTransitionError: It was called before, or the goal has ended.
        """
        # A goal that is to be canceled is run too: its callback knows how to end it.
        if not self.is_cancel_requested:
            self.update(GoalEvent.EXECUTE)
        self.is_started = True
        self._action_server.notify_execute(self, execute_callback)

    def executing(self) -> None:
        """Say that the goal is being reached, by the program's own means in place of `execute`.

        Raises:
            GoalTransitionError: It was said before, or the goal has ended.
        """
        self.update(GoalEvent.EXECUTE)

    def publish_feedback(self, feedback: FeedbackT) -> None:
        """Tell the client how it goes.

        Raises:
            ActionMessageError: This is not the action's `Feedback`.
        """
        if not self._is_destroyed:
            self._action_server.publish_feedback(self, feedback)

    def succeed(self, response: ResultT | None = None) -> None:
        """End the goal: it was reached.

        Args:
            response: The result, sent at once; else the one that the callback returns.

        Raises:
            GoalTransitionError: The goal is not being executed.
            ActionMessageError: This is not the action's `Result`.
        """
        self._end(GoalEvent.SUCCEED, response)

    def abort(self, response: ResultT | None = None) -> None:
        """End the goal: the server gave it up; see `succeed`."""
        self._end(GoalEvent.ABORT, response)

    def canceled(self, response: ResultT | None = None) -> None:
        """End the goal, as the client asked for; see `succeed`."""
        self._end(GoalEvent.CANCELED, response)

    def _end(self, event: GoalEvent, result: ResultT | None) -> None:
        if result is not None:
            self._action_server.check_result(result)
        self.update(event)
        if result is not None or not self.is_started:
            self.deliver(result)  # nothing else will come from a callback

    def update(self, event: GoalEvent) -> None:
        """Change the goal's state and tell everybody; nothing happens to a forgotten goal.

        Raises:
            GoalTransitionError: The state does not allow it.
        """
        with self._action_server.lock:
            if self._is_destroyed:
                return
            self._status.status = next_state(self.state, event).value
            self._action_server.publish_status()

    def deliver(self, result: ResultT | None) -> None:
        """Send the result to all who asked or will ask for it; only the first counts."""
        if not self.result_future.is_over and not self._is_destroyed:
            self._action_server.deliver(self, result)

    def destroy(self) -> None:
        """Forget the goal: nothing that is done with it from now on has an effect."""
        self._is_destroyed = True
