"""Action clients. They send goals to a server, and get feedback and results."""

from __future__ import annotations

import contextlib
import inspect
import threading
import uuid
import weakref
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar, cast

from zbot.action.client_goal_handle import ClientGoalHandle, SentGoal
from zbot.action.endpoint import (
    ActionEndpoint,
    FeedbackT,
    GoalT,
    ResultT,
    WorkQueue,
    check_arguments,
)
from zbot.action.errors import ActionMessageError
from zbot.action.feedback import FeedbackSubscription
from zbot.action.goal_state import GoalState
from zbot.errors import InvalidHandleError
from zbot.executor.callback_check import check_callback, unless_called
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.clock import Clock
from zbot.executor.task import Future
from zbot.executor.timer import Timer
from zbot.executor.waitable import NumberOfEntities
from zbot.node.argument_check import is_name
from zbot.node.errors import ServiceError
from zbot.qos import (
    QoSProfile,
    qos_profile_action_status_default,
    qos_profile_services_default,
)
from zbot.threads.deadline import Deadline
from zbot.time import S_TO_NS, ClockType, as_seconds

from action_msgs.srv import CancelGoal
from unique_identifier_msgs.msg import UUID

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.node.node import Node
    from zbot.time import Duration

    from action_msgs.msg import GoalStatus

T = TypeVar("T")

qos_profile_action_feedback = QoSProfile(depth=10)
_SERVER_TIMEOUT_S = 3.0  # a goal waits this long for a server that starts
_STEP_S = 0.5  # time between two attempts to send a goal


class _ActionFuture(Future[T]):
    """A future that the executor completes. The same thread runs its done callbacks immediately."""

    def __init__(self, node: Node) -> None:
        super().__init__()
        self._node = node
        self.fails_without_server = False  #: otherwise it is never done, as in rclpy

    def _run(self, callback: Callable[[Any], Any]) -> None:
        outcome = callback(self)
        executor = self._node.executor
        if inspect.iscoroutine(outcome) and executor is not None:
            executor.create_task(outcome)


class ActionClient(ActionEndpoint[GoalT, ResultT, FeedbackT]):
    """Sends goals. `ActionClient` has three service clients and two subscriptions of a node.

    The names of the services and topics begin with the action's name. All methods may be called
    from any thread.

    Args:
        node: The node that sends the goals.
        action_type: Action class.
        action_name: Relative, `~/private` or absolute name.
        callback_group: Group of the callbacks. If left out, the node's default group is used.
        goal_service_qos_profile: For the service that receives goals.
        result_service_qos_profile: For the service that returns results.
        cancel_service_qos_profile: For the service that cancels goals.
        feedback_sub_qos_profile: For the topic with the feedback.
        status_sub_qos_profile: For the topic with the states of all goals.

    Raises:
        NotAnActionTypeError: The class is not an action type.
        InvalidServiceNameError: The name breaks ROS 2's grammar.
        InvalidHandleError: The node was destroyed.
    """

    def __init__(
        self,
        node: Node,
        action_type: type[Any],
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = qos_profile_action_feedback,
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
    ) -> None:
        check_arguments("ActionClient", node, action_type, (action_name, is_name))
        self._node = node
        self._action_type = action_type
        self._action_name = node.resolve_service_name(action_name)
        self._lock = threading.RLock()  # re-entrant: a signal handler may take it
        self._has_warned = False  #: whether a missing server was logged
        self._goals: dict[bytes, SentGoal] = {}
        impl, name = action_type.Impl, f"{self._action_name}/_action"
        # The subscription is made before the clients. So no feedback of the first goal is lost.
        self._feedback = FeedbackSubscription(
            node,
            impl.FeedbackMessage,
            f"{name}/feedback",
            self._on_feedback,
            qos_profile=feedback_sub_qos_profile,
            callback_group=callback_group or node.default_callback_group,
            goal_count=self._goals.__len__,
        )
        # A reentrant group is enough, because no callbacks of the user run in it.
        internal_group = ReentrantCallbackGroup()
        self._work_queue = WorkQueue(node.handle.ready_queue, internal_group)
        self._timers: list[Timer] = []  # one for each goal that waits for a server
        self._status = node.create_subscription(
            impl.GoalStatusMessage,
            f"{name}/status",
            self._on_status,
            status_sub_qos_profile,
            callback_group=internal_group,
        )
        self._status.report_losses_to(_ignore_losses)  # each message has all states
        connect = partial(node.create_client, callback_group=callback_group)
        self._goal_client = connect(
            impl.SendGoalService, f"{name}/send_goal", qos_profile=goal_service_qos_profile
        )
        self._result_client = connect(
            impl.GetResultService, f"{name}/get_result", qos_profile=result_service_qos_profile
        )
        self._cancel_client = connect(
            impl.CancelGoalService, f"{name}/cancel_goal", qos_profile=cancel_service_qos_profile
        )
        self._services = [self._goal_client, self._result_client, self._cancel_client]

    def server_is_ready(self) -> bool:
        """Return whether there is a server that has all its services and topics."""
        is_served = all(client.service_is_ready() for client in self._services)
        return is_served and self._has_publishers()

    def _has_publishers(self) -> bool:
        graph = self._node.context.graph
        graph.watch()
        snapshot = graph.snapshot()
        topics = (self._feedback.topic_name, self._status.topic_name)
        return all(snapshot.publishers(topic) for topic in topics)

    def _has_one_server(self) -> bool:
        return len(self._node.context.graph.snapshot().publishers(self._status.topic_name)) == 1

    def wait_for_goal_service(self, timeout_sec: float) -> bool:
        """Wait for the service that receives goals. Ignore the other parts of an action server."""
        return self._goal_client.wait_for_service(timeout_sec)

    def wait_for_server(self, timeout_sec: float | Duration | None = None) -> bool:
        """Wait for a server.

        Args:
            timeout_sec: Seconds to wait, or a `Duration`. With `None`, only the context's shutdown
                limits the wait. With a negative number, do not wait.

        Returns:
            Whether there is a server.

        Raises:
            InvalidHandleError: The client or its node was destroyed.
            ArgumentTypeError: `timeout_sec` is neither a number nor a `Duration`.
        """
        deadline = Deadline(as_seconds("timeout_sec", timeout_sec))
        for client in (self._cancel_client, self._result_client, self._goal_client):
            if not client.wait_for_service(deadline.left_s):
                return False
        self._node.context.graph.wait_for(lambda _: self._has_publishers(), deadline.left_s)
        return self.server_is_ready()

    def send_goal_async(
        self,
        goal: GoalT,
        feedback_callback: Callable[[Any], Any] | None = None,
        goal_uuid: UUID | None = None,
    ) -> Future[ClientGoalHandle[GoalT, ResultT, FeedbackT]]:
        """Send a goal.

        Args:
            goal: The goal, of the action's `Goal` class.
            feedback_callback: Takes each feedback message, which has `feedback` and `goal_id`. It
                may be a coroutine function.
            goal_uuid: The goal's id. If left out, a random id is used.

        Returns:
            A future of the goal's handle. The future is done when the server has accepted or
            rejected the goal. The future fails with `ServiceError` if the server ends before it
            answers. If there is no server within 3 s, the goal is lost: as in rclpy, the future is
            never done, and the client's first such goal logs a warning.

        Raises:
            ActionMessageError: `goal` is not of the action's `Goal` class.
            WrongTypeError: The feedback callback is not callable.
            WrongStateError: The feedback callback does not take one argument.
        """
        check_callback(
            "send_goal_async",
            feedback_callback,
            "(feedback_message)",
            argument="feedback_callback",
            position=1,
            may_be_none=unless_called,
        )
        return self._start_goal(goal, feedback_callback, goal_uuid, _ActionFuture(self._node))

    def send_goal_to_server_async(
        self, goal: GoalT, feedback_callback: Callable[[Any], Any] | None = None
    ) -> Future[ClientGoalHandle[GoalT, ResultT, FeedbackT]]:
        """Send a goal as in `send_goal_async`. If there is no server within 3 s, the future fails.

        Returns:
            A future as that of `send_goal_async`. Its exception is a `ServiceError` with the kind
            `no_server` if there is no server.
        """
        future: _ActionFuture[ClientGoalHandle[GoalT, ResultT, FeedbackT]]
        future = _ActionFuture(self._node)
        future.fails_without_server = True
        return self._start_goal(goal, feedback_callback, None, future)

    def _start_goal(
        self,
        goal: GoalT,
        feedback_callback: Callable[[Any], Any] | None,
        goal_uuid: UUID | None,
        future: _ActionFuture[ClientGoalHandle[GoalT, ResultT, FeedbackT]],
    ) -> Future[ClientGoalHandle[GoalT, ResultT, FeedbackT]]:
        request = self._request(goal, goal_uuid)
        self._remember(request.goal_id, feedback_callback)
        self._send(request, future, Deadline(_SERVER_TIMEOUT_S))
        return future

    def _send(
        self,
        request: Any,
        future: _ActionFuture[ClientGoalHandle[GoalT, ResultT, FeedbackT]],
        deadline: Deadline,
    ) -> None:
        response = self._goal_client.call_server_async(request)
        self._then(response, partial(self._on_goal_response, request, future, response, deadline))

    def _send_later(self, *arguments: Any) -> None:
        def send() -> None:
            if self._drop_timer(timer):
                # The error means that another thread has destroyed the client. The future then
                # stays pending.
                with contextlib.suppress(InvalidHandleError):
                    self._send(*arguments)

        ready_queue, steady = self._node.handle.ready_queue, Clock(clock_type=ClockType.STEADY_TIME)
        timer = Timer(
            send, self._work_queue.callback_group, int(_STEP_S * S_TO_NS), steady, ready_queue
        )
        self._timers.append(timer)
        ready_queue.add(timer)

    def _drop_timer(self, timer: Timer) -> bool:
        with self._lock:
            if timer not in self._timers:
                return False
            self._timers.remove(timer)
        self._node.handle.ready_queue.remove(timer)
        timer.destroy()
        return True

    def _then(self, response: Future[Any], function: Callable[[], None]) -> None:
        # This is a waker and not a done callback. A done callback would wait for its callback
        # group. A callback that awaits the response may hold this group.
        response.add_waker(partial(self._work_queue.add, function))

    def _request(self, goal: GoalT, goal_uuid: UUID | None) -> Any:
        expected = self._action_type.Goal
        if not isinstance(goal, expected):
            raise ActionMessageError(self._action_name, expected, goal)
        if goal_uuid is None:
            goal_uuid = UUID(uuid=list(uuid.uuid4().bytes))
        return self._action_type.Impl.SendGoalService.Request(goal_id=goal_uuid, goal=goal)

    def _remember(self, goal_id: UUID, feedback_callback: Callable[[Any], Any] | None) -> None:
        with self._lock:
            self._goals.setdefault(bytes(goal_id.uuid), SentGoal(feedback_callback))

    def _forget(self, key: bytes) -> None:
        with self._lock:
            self._goals.pop(key, None)

    def _finish(
        self, handle: ClientGoalHandle[GoalT, ResultT, FeedbackT], status: int | None = None
    ) -> None:
        """Forget a goal after its result and after the callback for its last feedback."""
        with self._lock:
            if status is not None:
                handle.status = status
            if (goal := self._goals.get(handle.key)) is not None:
                goal.is_over = True
        if self._feedback.is_empty:
            self._forget(handle.key)

    def _on_goal_response(
        self,
        request: Any,
        future: _ActionFuture[ClientGoalHandle[GoalT, ResultT, FeedbackT]],
        response: Future[Any],
        deadline: Deadline,
    ) -> None:
        error = response.exception()
        if error is None:
            future.set_result(self._handle(request.goal_id, response.result()))
        elif _is_server_missing(error) and not deadline.is_over:
            self._send_later(request, future, deadline)
        else:
            self._forget(bytes(request.goal_id.uuid))
            if not _is_server_missing(error):
                future.set_exception(error)
            elif future.fails_without_server:
                text = "no server is running; start it, and send the goal again"
                future.set_exception(ServiceError(self._action_name, "no_server", text))
            else:
                self._warn_of_lost_goal()

    def _warn_of_lost_goal(self) -> None:
        if not self._has_warned:
            self._has_warned = True
            self._node.get_logger().warning(
                f"this goal gets no response: {self._action_name}: no server is running; start it, "
                "or wait for it with wait_for_server()"
            )

    def _handle(self, goal_id: UUID, response: Any) -> ClientGoalHandle[GoalT, ResultT, FeedbackT]:
        handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
        handle = ClientGoalHandle(self, goal_id, response)
        with self._lock:
            goal = self._goals.get(handle.key)
            if not handle.accepted:
                self._forget(handle.key)
            elif goal is not None:
                goal.handle = weakref.ref(handle)
                handle.status = goal.state.value
        return handle

    def send_goal(
        self,
        goal: GoalT,
        feedback_callback: Callable[[Any], Any] | None = None,
        goal_uuid: UUID | None = None,
    ) -> Any:
        """Send a goal and wait for its result.

        The feedback callback is called only if another thread spins the node.

        Args:
            goal: See `send_goal_async`.
            feedback_callback: See `send_goal_async`.
            goal_uuid: See `send_goal_async`.

        Returns:
            A response that has the goal's `status` and `result`. If the goal was not accepted, the
            status is `UNKNOWN`.

        Raises:
            ActionMessageError: `goal` is not of the action's `Goal` class.
            ServiceError: There is no server, or it ended before the goal did.
        """
        request = self._request(goal, goal_uuid)
        self._remember(request.goal_id, feedback_callback)
        try:
            handle = self._handle(request.goal_id, self._goal_client.call(request))
            return self.get_result(handle)
        except BaseException:
            self._forget(bytes(request.goal_id.uuid))
            raise

    def get_result_async(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> Future[Any]:
        """Return a future of a goal's result (see `ClientGoalHandle`)."""
        future: _ActionFuture[Any] = _ActionFuture(self._node)
        response = self._result_client.call_server_async(self._result_request(goal_handle))
        self._then(response, partial(self._on_result, goal_handle, future, response))
        return future

    def _result_request(self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]) -> Any:
        return self._action_type.Impl.GetResultService.Request(goal_id=goal_handle.goal_id)

    def _on_result(
        self,
        handle: ClientGoalHandle[GoalT, ResultT, FeedbackT],
        future: _ActionFuture[Any],
        response: Future[Any],
    ) -> None:
        executor = self._node.executor
        while executor is not None and executor.serve(self._feedback):
            continue  # run the callbacks for all feedback before the result is set
        error = response.exception()
        if error is None:
            result: Any = response.result()
            self._finish(handle, result.status)
            future.set_result(result)
        else:
            self._finish(handle)
            future.set_exception(error)

    def get_result(self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]) -> Any:
        """Wait for a goal's result and return it (see `ClientGoalHandle`)."""
        try:
            response = self._result_client.call(self._result_request(goal_handle))
        except ServiceError:
            self._finish(goal_handle)
            raise
        self._finish(goal_handle, response.status)
        return response

    def cancel_goal_async(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> Future[CancelGoal.Response]:
        """Ask the server to cancel a goal (see `ClientGoalHandle`)."""
        return self._cancel_client.call_server_async(_cancel_request(goal_handle))

    def cancel_goal(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> CancelGoal.Response:
        """Ask the server to cancel a goal, and wait for the response (see `ClientGoalHandle`)."""
        return cast("CancelGoal.Response", self._cancel_client.call(_cancel_request(goal_handle)))

    # rclpy's private names of these methods. Programs such as smach_ros use them.
    _get_result, _get_result_async = get_result, get_result_async
    _cancel_goal, _cancel_goal_async = cancel_goal, cancel_goal_async

    def _on_feedback(self, message: Any) -> Any:
        goal = self._goals.get(bytes(message.goal_id.uuid))
        if goal is None or goal.feedback_callback is None:
            return None
        return goal.feedback_callback(message)

    def _on_status(self, message: Any) -> None:
        status: GoalStatus
        with self._lock:
            known = dict(self._goals)
            for status in message.status_list:
                goal = known.pop(bytes(status.goal_info.goal_id.uuid), None)
                if goal is not None:
                    goal.set_state(GoalState(status.status))
        for key, goal in known.items():
            # The server's list does not have this goal. There are two reasons to forget the goal.
            # The goal has ended, and the server has forgotten it. Or an earlier list had the goal:
            # then this list comes from another server, and the goal's own server is gone.
            was_listed = goal.state is not GoalState.UNKNOWN
            if goal.is_over or goal.state.is_terminal or (was_listed and self._has_one_server()):
                self._forget(key)

    def get_num_entities(self) -> NumberOfEntities:
        """Return the numbers of the client's entities, by kind."""
        return NumberOfEntities(num_subscriptions=2, num_clients=3)

    def destroy(self) -> None:
        """Destroy the client and forget its goals. A second call does nothing."""
        for subscription in (cast("Any", self._feedback), self._status):
            self._node.destroy_subscription(subscription)
        self._work_queue.destroy()
        for timer in list(self._timers):
            self._drop_timer(timer)
        for client in self._services:
            self._node.destroy_client(client)
        with self._lock:
            self._goals.clear()


def _ignore_losses(missing: int) -> None:  # noqa: ARG001 - a subscription's callback
    return


def _is_server_missing(error: BaseException) -> bool:
    return isinstance(error, ServiceError) and error.kind == "no_server"


def _cancel_request(goal_handle: ClientGoalHandle[Any, Any, Any]) -> CancelGoal.Request:
    request = CancelGoal.Request()
    request.goal_info.goal_id = goal_handle.goal_id
    return request
