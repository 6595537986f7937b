"""Action servers. They execute goals, publish feedback, and can cancel goals."""

from __future__ import annotations

import threading
import traceback
from collections import deque
from enum import Enum
from functools import partial
from typing import TYPE_CHECKING, Any, cast

from zbot.action.cancellation import ERROR_REJECTED, CancelQuery
from zbot.action.endpoint import (
    ActionEndpoint,
    FeedbackT,
    GoalT,
    ResultT,
    WorkQueue,
    check_arguments,
)
from zbot.action.errors import ActionMessageError
from zbot.action.goal_state import GoalEvent, GoalState, GoalTransitionError
from zbot.action.server_goal_handle import ServerGoalHandle
from zbot.action.service import Reply, create_action_service
from zbot.errors import InvalidHandleError
from zbot.executor.callback_check import check_callback, unless_called
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.task import await_or_execute
from zbot.executor.timer import Timer
from zbot.executor.waitable import NumberOfEntities
from zbot.node.argument_check import is_name
from zbot.process.hooks import advise, user_traceback
from zbot.qos import (
    QoSProfile,
    qos_profile_action_status_default,
    qos_profile_services_default,
)
from zbot.time import S_TO_NS

from action_msgs.msg import GoalInfo

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.node.node import Node


qos_profile_action_feedback = QoSProfile(depth=10)


class GoalResponse(Enum):
    """Answer that accepts or rejects a goal."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """Answer that accepts or rejects a cancel request."""

    REJECT = 1
    ACCEPT = 2


def default_handle_accepted_callback(goal_handle: ServerGoalHandle[Any, Any, Any]) -> None:
    """Execute the goal immediately."""
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:  # noqa: ARG001 - rclpy's signature
    """Accept every goal."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:  # noqa: ARG001 - as above
    """Reject every cancel request."""
    return CancelResponse.REJECT


class ActionServer(ActionEndpoint[GoalT, ResultT, FeedbackT]):
    """Executes goals. `ActionServer` has three services and two publishers of a node.

    The names of the services and topics begin with the action's name. All callbacks may be
    coroutine functions. As in rclpy, goals are executed outside of callback groups. So several
    threads, or coroutines, can execute many goals at the same time.

    Args:
        node: The node of the server.
        action_type: Action class.
        action_name: Relative, `~/private` or absolute name.
        execute_callback: Takes a `ServerGoalHandle`, and returns the action's `Result`. A goal is
            aborted if the callback raises an exception or does not end the goal. The callback may
            be left out if `handle_accepted_callback` executes the goals itself.
        callback_group: Group of the other callbacks. If left out, the node's default group is used.
        goal_callback: Takes the `Goal`, and returns a `GoalResponse`. If left out, the server
            accepts every goal.
        handle_accepted_callback: Takes the `ServerGoalHandle` of an accepted goal, after the
            client got the response. The callback must call the handle's `execute()`, or the
            program must call it later.
        cancel_callback: Takes a `ServerGoalHandle`, and returns a `CancelResponse`. If left out,
            the server rejects every request.
        goal_service_qos_profile: For the service that receives goals.
        result_service_qos_profile: For the service that returns results.
        cancel_service_qos_profile: For the service that cancels goals.
        feedback_pub_qos_profile: For the topic with the feedback.
        status_pub_qos_profile: For the topic with the states of all goals.
        result_timeout: Seconds for which the server keeps a result after the goal's end, on the
            node's clock. With a negative number, the server keeps results for ever.

    Raises:
        NotAnActionTypeError: The class is not an action type.
        WrongTypeError: A callback is not callable, or the execute callback is missing.
        WrongStateError: A callback does not take one argument.
        InvalidServiceNameError: The name breaks ROS 2's grammar.
        InvalidHandleError: The node was destroyed.
    """

    def __init__(
        self,
        node: Node,
        action_type: type[Any],
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle[GoalT, ResultT, FeedbackT]], Any]
        | None = None,
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: Callable[[Any], Any] | None = default_goal_callback,
        handle_accepted_callback: Callable[[Any], Any] | None = default_handle_accepted_callback,
        cancel_callback: Callable[[Any], Any] | None = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = qos_profile_action_feedback,
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: float = 10,
    ) -> None:
        given = () if execute_callback is None else ((execute_callback, callable),)
        check_arguments("ActionServer", node, action_type, (action_name, is_name), *given)
        self._execute_callback: Callable[[Any], Any] | None = None
        has_handler = handle_accepted_callback not in (None, default_handle_accepted_callback)
        if execute_callback is not None or not has_handler:
            self._check("execute_callback", "(goal_handle)", execute_callback, position=3)
            self._execute_callback = execute_callback
        self.register_goal_callback(goal_callback)
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_cancel_callback(cancel_callback)
        self.lock = threading.RLock()  #: held while a goal's state changes and is published
        self._node = node
        self._action_type = action_type
        self._action_name = node.resolve_service_name(action_name)
        self._logger = node.get_logger().get_child("action_server")
        self._goal_handles: dict[bytes, ServerGoalHandle[GoalT, ResultT, FeedbackT]] = {}
        self._clock = node.get_clock()  # it may be simulated
        self._result_timeout_ns = int(result_timeout * S_TO_NS)
        self._ended: deque[tuple[int, bytes]] = deque()  # expiry time of a result, id of its goal
        group = callback_group or node.default_callback_group
        unprotected = ReentrantCallbackGroup()  # for execute callbacks, results and the timer
        self._executions = WorkQueue(node.handle.ready_queue, unprotected)
        self._expiry = self._make_timer(unprotected)
        impl, name = action_type.Impl, f"{self._action_name}/_action"
        self._feedback = node.create_publisher(
            impl.FeedbackMessage, f"{name}/feedback", feedback_pub_qos_profile
        )
        self._status = node.create_publisher(
            impl.GoalStatusMessage, f"{name}/status", status_pub_qos_profile
        )
        serve = partial(create_action_service, node)
        self._services = [
            serve(
                impl.CancelGoalService,
                f"{name}/cancel_goal",
                self._on_cancel_request,
                qos_profile=cancel_service_qos_profile,
                callback_group=group,
            ),
            serve(
                impl.GetResultService,
                f"{name}/get_result",
                self._on_result_request,
                qos_profile=result_service_qos_profile,
                callback_group=unprotected,
            ),
            # This service is created last. When a client finds it, the other parts must exist too.
            serve(
                impl.SendGoalService,
                f"{name}/send_goal",
                self._on_goal_request,
                qos_profile=goal_service_qos_profile,
                callback_group=group,
            ),
        ]

    def _make_timer(self, group: CallbackGroup) -> Timer:
        ready_queue, period_ns = self._node.handle.ready_queue, max(self._result_timeout_ns, 0)
        timer = Timer(self._expire, group, period_ns, self._clock, ready_queue, autostart=False)
        ready_queue.add(timer)
        return timer

    @property
    def is_over(self) -> bool:
        """Whether the node was destroyed or the context was shut down."""
        return self._node.handle.is_destroyed or not self._node.context.is_running

    def register_execute_callback(
        self, execute_callback: Callable[[ServerGoalHandle[GoalT, ResultT, FeedbackT]], Any]
    ) -> None:
        """Replace the callback that executes goals.

        Raises:
            WrongTypeError: The callback is not callable.
            WrongStateError: The callback does not take one argument.
        """
        self._check("execute_callback", "(goal_handle)", execute_callback)
        self._execute_callback = execute_callback

    def _check(self, argument: str, form: str, callback: object, **options: Any) -> None:
        call = f"{type(self).__name__}'s {argument}"
        options |= {"argument": argument, "may_do_nothing": True}
        check_callback(call, callback, form, **options)

    def register_goal_callback(self, goal_callback: Callable[[Any], Any] | None) -> None:
        """Replace the callback that decides about new goals. `None` accepts all goals."""
        self._check("goal_callback", "(goal)", goal_callback, may_be_none=unless_called)
        self._goal_callback = goal_callback or default_goal_callback

    def register_handle_accepted_callback(
        self, handle_accepted_callback: Callable[[Any], Any] | None
    ) -> None:
        """Replace the callback that gets accepted goals. `None` executes the goals immediately."""
        given = handle_accepted_callback
        self._check("handle_accepted_callback", "(goal_handle)", given, may_be_none=unless_called)
        self._handle_accepted_callback = (
            handle_accepted_callback or default_handle_accepted_callback
        )

    def register_cancel_callback(self, cancel_callback: Callable[[Any], Any] | None) -> None:
        """Replace the callback that decides about cancel requests. `None` rejects all requests."""
        self._check("cancel_callback", "(goal_handle)", cancel_callback, may_be_none=unless_called)
        self._cancel_callback = cancel_callback or default_cancel_callback

    async def _on_goal_request(self, request: Any, response: Any) -> Reply | Any:
        key = bytes(request.goal_id.uuid)
        if key not in self._goal_handles and await self._is_accepted(request.goal):
            info = GoalInfo(goal_id=request.goal_id, stamp=self._node.get_clock().now().to_msg())
            handle: ServerGoalHandle[GoalT, ResultT, FeedbackT]
            handle = ServerGoalHandle(self, info, request.goal)
            if self._goal_handles.setdefault(key, handle) is handle:
                response.accepted, response.stamp = True, info.stamp
                return Reply(response, partial(self._accept, handle))
        self._logger.debug(f"New goal rejected: {key.hex()}")
        return response

    async def _is_accepted(self, goal: Any) -> bool:
        decision = await await_or_execute(self._goal_callback, goal)
        if isinstance(decision, GoalResponse):
            return decision is GoalResponse.ACCEPT
        self._logger.warning(
            f"{self._action_name}: the goal callback returned {decision!r}, not a GoalResponse: "
            "the goal is rejected"
        )
        return False

    def _accept(self, handle: ServerGoalHandle[GoalT, ResultT, FeedbackT]) -> Any:
        self._logger.debug(f"New goal accepted: {handle.key.hex()}")
        self.publish_status()
        return self._handle_accepted_callback(handle)

    async def _on_cancel_request(self, request: Any, response: Any) -> Any:
        info = request.goal_info
        stamp_ns = info.stamp.sec * S_TO_NS + info.stamp.nanosec
        query = CancelQuery(bytes(info.goal_id.uuid), stamp_ns)
        with self.lock:
            chosen, code = query.choose(list(self._goal_handles.values()))
        canceling = [handle for handle in chosen if await self._cancel(handle)]
        response.goals_canceling = [handle.goal_info for handle in canceling]
        response.return_code = ERROR_REJECTED if chosen and not canceling else code
        return response

    async def _cancel(self, handle: ServerGoalHandle[GoalT, ResultT, FeedbackT]) -> bool:
        if await await_or_execute(self._cancel_callback, handle) is not CancelResponse.ACCEPT:
            return False
        try:
            handle.update(GoalEvent.CANCEL_GOAL)
        except GoalTransitionError as error:  # the goal ended during the callback
            self._logger.debug(f"Failed to cancel goal {handle.key.hex()}: {error}")
            return False
        return True

    async def _on_result_request(self, request: Any, response: Any) -> Any:
        key = bytes(request.goal_id.uuid)
        handle = self._goal_handles.get(key)
        if handle is None:
            self._logger.warning(
                f"{self._action_name}: a client asked for the result of a goal that is unknown or "
                f"expired: {key.hex()}"
            )
            response.status = GoalState.UNKNOWN.value
            return response
        return handle.result_future

    def notify_execute(
        self,
        goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT],
        execute_callback: Callable[[ServerGoalHandle[GoalT, ResultT, FeedbackT]], Any] | None,
    ) -> None:
        """Let the executor run a goal (see `ServerGoalHandle.execute`)."""
        callback = execute_callback or self._execute_callback
        if callback is None:
            goal_handle.is_started = False  # the program executes the goal itself
            return
        self._executions.add(partial(self._execute, goal_handle, callback))

    async def _execute(
        self,
        handle: ServerGoalHandle[GoalT, ResultT, FeedbackT],
        callback: Callable[[ServerGoalHandle[GoalT, ResultT, FeedbackT]], Any],
    ) -> None:
        self._logger.debug(f"Executing goal with ID {handle.key.hex()}")
        result = None
        try:
            result = self._checked(handle, await await_or_execute(callback, handle))
        except Exception as error:  # noqa: BLE001 - the server goes on after one goal failed
            if self.is_over:
                return  # the program ends, and clients see that the server is gone
            self._report(error)
        else:
            if handle.is_active:
                self._logger.warning(
                    f"Goal state not set, assuming aborted. Goal ID: {handle.key.hex()}"
                )
        with self.lock:
            if handle.is_active:
                handle.update(GoalEvent.ABORT)
        handle.deliver(result)

    def _checked(
        self, handle: ServerGoalHandle[GoalT, ResultT, FeedbackT], result: Any
    ) -> ResultT | None:
        if result is not None:
            self.check_result(result)
        elif not handle.result_future.is_over:
            self._logger.warning(
                f"{self._action_name}: the execute callback returned no result, so an empty one is "
                "sent; end the callback with `return result`"
            )
        return cast("ResultT | None", result)

    def _report(self, error: Exception) -> None:
        advise(error)
        lines = traceback.format_exception(type(error), error, user_traceback(error.__traceback__))
        self._logger.error(f"Error raised in execute callback: {error}\n{''.join(lines).rstrip()}")

    def check_result(self, result: object) -> None:
        """Raise an error if a value is not a result of this action.

        Raises:
            ActionMessageError: The value is not of the action's `Result` class.
        """
        expected = self._action_type.Result
        if not isinstance(result, expected):
            raise ActionMessageError(self._action_name, expected, result)

    def deliver(
        self, handle: ServerGoalHandle[GoalT, ResultT, FeedbackT], result: ResultT | None
    ) -> None:
        """Send a goal's result to the clients that requested it, and keep it for later requests."""
        response = self._action_type.Impl.GetResultService.Response()
        response.status = handle.status
        response.result = self._action_type.Result() if result is None else result
        with self.lock:
            if handle.result_future.is_over:
                return
            handle.result_future.set_result(response)
            self._ended.append((self._now_ns() + self._result_timeout_ns, handle.key))
            if len(self._ended) == 1:
                self._schedule_expiry()

    def _schedule_expiry(self) -> None:
        if self._ended and self._result_timeout_ns >= 0:
            self._expiry.timer_period_ns = max(0, self._ended[0][0] - self._now_ns())
            self._expiry.reset()
        else:
            self._expiry.cancel()

    def _now_ns(self) -> int:
        return self._clock.now().nanoseconds

    def _expire(self) -> None:
        now = self._now_ns()
        with self.lock:
            while self._ended and self._ended[0][0] <= now:
                _, key = self._ended.popleft()
                self._goal_handles.pop(key).destroy()
            self._schedule_expiry()

    def publish_status(self) -> None:
        """Publish the states of all known goals."""
        message = self._action_type.Impl.GoalStatusMessage()
        with self.lock:
            handles = list(self._goal_handles.values())  # another thread may accept a goal
            message.status_list = [handle.status_message for handle in handles]
            try:
                self._status.publish(message)
            except InvalidHandleError:  # no error if another thread has just destroyed the node
                if not self.is_over:
                    raise

    def publish_feedback(
        self, handle: ServerGoalHandle[GoalT, ResultT, FeedbackT], feedback: FeedbackT
    ) -> None:
        """Publish feedback of a goal (see `ServerGoalHandle.publish_feedback`)."""
        expected = self._action_type.Feedback
        if not isinstance(feedback, expected):
            raise ActionMessageError(self._action_name, expected, feedback)
        message = self._action_type.Impl.FeedbackMessage(goal_id=handle.goal_id, feedback=feedback)
        self._feedback.publish(message)

    def get_num_entities(self) -> NumberOfEntities:
        """Return the numbers of the server's entities, by kind."""
        return NumberOfEntities(num_timers=1, num_services=len(self._services))

    def destroy(self) -> None:
        """Destroy the server. Clients that wait for a result get an error.

        This method may be called twice.
        """
        for service in self._services:
            self._node.destroy_service(service)
        with self.lock:
            for handle in list(self._goal_handles.values()):
                handle.destroy()
            self._goal_handles.clear()
            self._ended.clear()
        self._node.destroy_publisher(self._feedback)
        self._node.destroy_publisher(self._status)
        self._expiry.destroy()
        self._node.handle.ready_queue.remove(self._expiry)
        self._executions.destroy()
