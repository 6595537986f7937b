"""Handle of a goal for an action client, and what the client stores for it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from zbot.action.endpoint import ActionGeneric, FeedbackT, GoalT, ResultT
from zbot.action.goal_state import GoalState

if TYPE_CHECKING:
    import weakref
    from collections.abc import Callable

    from zbot.executor.task import Future

    from action_msgs.srv import CancelGoal
    from builtin_interfaces.msg import Time
    from unique_identifier_msgs.msg import UUID


class GoalClient(Protocol):
    """The part of an action client that a goal uses."""

    def get_result(self, goal_handle: Any) -> Any:
        """Wait for a goal's result and return it."""
        ...

    def get_result_async(self, goal_handle: Any) -> Future[Any]:
        """Return a future of a goal's result."""
        ...

    def cancel_goal(self, goal_handle: Any) -> CancelGoal.Response:
        """Ask the server to cancel a goal, and wait for the response."""
        ...

    def cancel_goal_async(self, goal_handle: Any) -> Future[CancelGoal.Response]:
        """Ask the server to cancel a goal. Return a future of the response."""
        ...


class ClientGoalHandle(ActionGeneric[GoalT, ResultT, FeedbackT]):
    """A goal that was sent. Its methods get the result, or cancel the goal.

    `ActionClient` makes the handle. All methods may be called from any thread.

    Args:
        action_client: The client that sent the goal.
        goal_id: The goal's id.
        goal_response: The server's response to the goal.
    """

    status: int  #: number of the goal's last known state (GoalStatus)

    def __init__(
        self,
        action_client: GoalClient,
        goal_id: UUID,
        goal_response: Any,
    ) -> None:
        self._action_client = action_client
        self._goal_id = goal_id
        self._goal_response = goal_response
        self.status = 0

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

    def __repr__(self) -> str:
        return (
            f"ClientGoalHandle <id={self.key.hex()}, accepted={self.accepted}, "
            f"status={self.status}>"
        )

    @property
    def key(self) -> bytes:
        """The goal's id, 16 bytes."""
        return bytes(self._goal_id.uuid)

    @property
    def goal_id(self) -> UUID:
        """The goal's id."""
        return self._goal_id

    @property
    def stamp(self) -> Time:
        """When the server accepted the goal, by the server's clock."""
        stamp: Time = self._goal_response.stamp
        return stamp

    @property
    def accepted(self) -> bool:
        """Whether the server accepted the goal."""
        return bool(self._goal_response.accepted)

    def get_result(self) -> Any:
        """Wait for the goal's end. Return a response that has the goal's `status` and `result`.

        Raises:
            ServiceError: The server ended before the goal did.
            NotInitializedError: The context was shut down during the wait.
        """
        return self._action_client.get_result(self)

    def get_result_async(self) -> Future[Any]:
        """Return a future of a response that has the goal's `status` and `result`.

        The future fails with `ServiceError` if the server ends before the goal does.
        """
        return self._action_client.get_result_async(self)

    def cancel_goal(self) -> CancelGoal.Response:
        """Ask the server to cancel the goal, and return the response.

        The response has the goals that the server cancels.

        Raises:
            ServiceError: There is no server.
            NotInitializedError: The context was shut down during the wait.
        """
        return self._action_client.cancel_goal(self)

    def cancel_goal_async(self) -> Future[CancelGoal.Response]:
        """Ask the server to cancel the goal. Return a future of the response."""
        return self._action_client.cancel_goal_async(self)


class SentGoal:
    """A goal that a client stores until the result has come and all feedback is handled."""

    def __init__(self, feedback_callback: Callable[[Any], Any] | None) -> None:
        self.feedback_callback = feedback_callback
        self.handle: weakref.ref[ClientGoalHandle[Any, Any, Any]] | None = None
        self.state = GoalState.UNKNOWN
        self.is_over = False  #: whether the result has come

    def set_state(self, state: GoalState) -> None:
        """Set the goal's state. If there is no handle yet, the handle gets the state later.

        After the result has come, the state does not change, because an older state may come later.
        """
        if self.is_over:
            return
        self.state = state
        handle = self.handle() if self.handle is not None else None
        if handle is not None:
            handle.status = state.value
