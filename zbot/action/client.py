"""Action clients: they send goals to a server, and hear how it goes."""

from __future__ import annotations

import contextlib
import inspect
import threading
import time
import uuid
import weakref
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar, cast

from zbot.action.client_goal_handle import ClientGoalHandle
from zbot.action.errors import ActionMessageError, NotAnActionTypeError
from zbot.action.feedback import FeedbackSubscription
from zbot.action.generic import ActionGeneric, FeedbackT, GoalT, ResultT
from zbot.action.goal_state import GoalState
from zbot.action.work_queue import WorkQueue
from zbot.errors import InvalidHandleError
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.clock import Clock
from zbot.executor.task import Future
from zbot.executor.timer import Timer
from zbot.executor.waitable import NumberOfEntities
from zbot.interfaces import type_name
from zbot.node.errors import ServiceError
from zbot.qos import (
    QoSProfile,
    qos_profile_action_status_default,
    qos_profile_services_default,
)
from zbot.time import S_TO_NS, ClockType

from action_msgs.srv import CancelGoal
from unique_identifier_msgs.msg import UUID

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

    from typing_extensions import Self

    from zbot.executor.callback_group import CallbackGroup
    from zbot.node.node import Node
    from zbot.node.service_introspection import ServiceIntrospectionState

    from action_msgs.msg import GoalStatus

T = TypeVar("T")

qos_profile_action_feedback = QoSProfile(depth=10)
_PATIENCE_S = 3.0  # that a goal waits for a server that is just starting; rclpy's wait for ever
_STEP_S = 0.5  # a shutdown wakes nobody who waits for the graph


class _Goal:
    """What a client keeps of a goal until its result has come."""

    def __init__(self, feedback_callback: Callable[[Any], Any] | None) -> None:
        self.feedback_callback = feedback_callback
        self.handle: weakref.ref[ClientGoalHandle[Any, Any, Any]] | None = None
        self.state = GoalState.UNKNOWN
        self.is_over = False  #: whether its result has come

    def tell(self, state: GoalState) -> None:
        """Note where the goal stands; what was heard before the handle came counts too."""
        self.state = state
        handle = self.handle() if self.handle is not None else None
        if handle is not None:
            handle.status = state.value


class _Answer(Future[T]):
    """Something that comes later; completed in the executor, where its callbacks run."""

    def __init__(self, node: Node) -> None:
        super().__init__()
        self._node = node

    def _run(self, callback: Callable[[Any], Any]) -> None:
        outcome = callback(self)
        executor = self._node.executor
        if inspect.iscoroutine(outcome) and executor is not None:
            executor.create_task(outcome)


class ActionClient(ActionGeneric[GoalT, ResultT, FeedbackT]):
    """Sends goals: three clients and two subscriptions of a node, below one name.

    All methods may be called from any thread.

    Args:
        node: The node that asks.
        action_type: Action class.
        action_name: Relative, `~/private` or absolute name.
        callback_group: Decides beside what the callbacks may run; the node's if left out.
        goal_service_qos_profile: Of the service that takes goals.
        result_service_qos_profile: Of the service that gives results.
        cancel_service_qos_profile: Of the service that cancels goals.
        feedback_sub_qos_profile: Of the topic that tells how it goes.
        status_sub_qos_profile: Of the topic that tells where each goal stands.

    Raises:
        NotAnActionTypeError: The class is no action's.
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
        if not hasattr(action_type, "Impl"):
            raise NotAnActionTypeError(action_type)
        self._node = node
        self._action_type = action_type
        self._action_name = node.resolve_service_name(action_name)
        self._lock = threading.RLock()  # re-entrant, for a signal's handler
        self._goals: dict[bytes, _Goal] = {}
        impl, name = action_type.Impl, f"{self._action_name}/_action"
        # First, so that nothing is missed of the first goal.
        self._feedback = FeedbackSubscription(
            node,
            impl.FeedbackMessage,
            f"{name}/feedback",
            self._on_feedback,
            qos_profile=feedback_sub_qos_profile,
            callback_group=callback_group or node.default_callback_group,
            goal_count=self._goals.__len__,
        )
        # No callbacks of the user run here, so nothing has to wait for a group's turn.
        free = ReentrantCallbackGroup()
        self._answers = WorkQueue(node.handle.ready_queue, free)
        self._timers: list[Timer] = []  # of goals that wait for a server
        self._status = node.create_subscription(
            impl.GoalStatusMessage,
            f"{name}/status",
            self._on_status,
            status_sub_qos_profile,
            callback_group=free,
        )
        self._status.report_losses_to(_take_no_notice)  # the last one tells all
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

    @property
    def action_type(self) -> type[Any]:
        """The action class."""
        return self._action_type

    @property
    def action_name(self) -> str:
        """The action's full name."""
        return self._action_name

    # -- is there a server? --------------------------------------------------------------------

    def server_is_ready(self) -> bool:
        """Return whether there is a server that a goal would reach, complete with its topics."""
        clients = (self._goal_client, self._result_client, self._cancel_client)
        return all(client.service_is_ready() for client in clients) and self._is_heard()

    def _is_heard(self) -> bool:
        graph = self._node.context.graph
        graph.watch()
        snapshot = graph.snapshot()
        topics = (self._feedback.topic_name, self._status.topic_name)
        return all(snapshot.publishers(topic) for topic in topics)

    def wait_for_goal_service(self, timeout_sec: float) -> bool:
        """Wait for who takes goals, complete with the rest of an action server or not."""
        return self._goal_client.wait_for_service(timeout_sec)

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server.

        Args:
            timeout_sec: Seconds; `None` or less than 0 for as long as the context lives.

        Returns:
            Whether there is one.

        Raises:
            InvalidHandleError: The client or its node was destroyed.
        """
        endless = timeout_sec is None or timeout_sec < 0
        deadline = time.monotonic() + (0 if timeout_sec is None or endless else timeout_sec)

        def left() -> float | None:
            return None if endless else max(0.0, deadline - time.monotonic())

        context = self._node.context
        for client in (self._cancel_client, self._result_client, self._goal_client):
            if not client.wait_for_service(left()):
                return False
        while context.ok() and not self._is_heard():
            remaining = left()
            step = _STEP_S if remaining is None else min(remaining, _STEP_S)
            if not step:
                return False
            context.graph.wait_for(lambda _: self._is_heard(), step)
        return self.server_is_ready()

    # -- goals ---------------------------------------------------------------------------------

    def send_goal_async(
        self,
        goal: GoalT,
        feedback_callback: Callable[[Any], Any] | None = None,
        goal_uuid: UUID | None = None,
    ) -> Future[ClientGoalHandle[GoalT, ResultT, FeedbackT]]:
        """Send a goal.

        Args:
            goal: What is to be reached.
            feedback_callback: Takes each feedback message: its `feedback` and `goal_id`; may be a
                coroutine function.
            goal_uuid: The goal's id; a random one if left out.

        Returns:
            A future of the goal's handle, done when the server has accepted or refused the goal. It
            fails with `ServiceError` when there is still no server after 3 s, or the server ends
            before that.

        Raises:
            ActionMessageError: This is not the action's `Goal`.
        """
        request = self._request(goal, goal_uuid)
        self._remember(request.goal_id, feedback_callback)
        answer: _Answer[ClientGoalHandle[GoalT, ResultT, FeedbackT]] = _Answer(self._node)
        self._send(request, answer, time.monotonic() + _PATIENCE_S)
        return answer

    def _send(
        self,
        request: Any,
        answer: _Answer[ClientGoalHandle[GoalT, ResultT, FeedbackT]],
        until: float,
    ) -> None:
        response = self._goal_client.call_async(request)
        told = partial(self._on_goal_response, request, answer, response, until)
        self._then(response, told)

    def _send_later(self, *sending: Any) -> None:
        def send() -> None:
            if self._drop_timer(timer):
                # Else another thread destroys the client, and nobody waits for the answer.
                with contextlib.suppress(InvalidHandleError):
                    self._send(*sending)

        ready_queue, steady = self._node.handle.ready_queue, Clock(clock_type=ClockType.STEADY_TIME)
        timer = Timer(
            send, self._answers.callback_group, int(_STEP_S * S_TO_NS), steady, ready_queue
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
        # Not as its done callback, which runs when its group is free: whoever awaits the answer may
        # hold the group meanwhile.
        response.add_waker(partial(self._answers.add, function))

    def _request(self, goal: GoalT, goal_uuid: UUID | None) -> Any:
        expected = self._action_type.Goal
        if not isinstance(goal, expected):
            raise ActionMessageError(self._action_name, type_name(expected), goal)
        if goal_uuid is None:
            goal_uuid = UUID(uuid=list(uuid.uuid4().bytes))
        return self._action_type.Impl.SendGoalService.Request(goal_id=goal_uuid, goal=goal)

    def _remember(self, goal_id: UUID, feedback_callback: Callable[[Any], Any] | None) -> None:
        with self._lock:
            self._goals.setdefault(bytes(goal_id.uuid), _Goal(feedback_callback))

    def _forget(self, key: bytes) -> None:
        with self._lock:
            self._goals.pop(key, None)

    def _finish(self, key: bytes) -> None:
        """Forget a goal whose result has come, once its feedback was told."""
        if self._feedback.is_empty:
            self._forget(key)
        elif (goal := self._goals.get(key)) is not None:
            goal.is_over = True

    def _on_goal_response(
        self,
        request: Any,
        answer: _Answer[ClientGoalHandle[GoalT, ResultT, FeedbackT]],
        response: Future[Any],
        until: float,
    ) -> None:
        error = response.exception()
        if error is None:
            answer.set_result(self._handle(request.goal_id, response.result()))
        elif _is_too_early(error) and time.monotonic() < until:
            self._send_later(request, answer, until)
        else:
            self._forget(bytes(request.goal_id.uuid))
            answer.set_exception(error)

    def _handle(self, goal_id: UUID, response: Any) -> ClientGoalHandle[GoalT, ResultT, FeedbackT]:
        handle = ClientGoalHandle(self, goal_id, response)
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
        """Send a goal and wait for its end; another thread must spin for the feedback.

        Args:
            goal: See `send_goal_async`.
            feedback_callback: See `send_goal_async`.
            goal_uuid: See `send_goal_async`.

        Returns:
            A response with the goal's `status` and `result`; the status is `UNKNOWN` for a goal
            that was not accepted.

        Raises:
            ActionMessageError: This is not the action's `Goal`.
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
        """Return a future of a goal's result; see `ClientGoalHandle`."""
        answer: _Answer[Any] = _Answer(self._node)
        response = self._result_client.call_async(self._result_request(goal_handle))
        self._then(response, partial(self._on_result, goal_handle, answer, response))
        return answer

    def _result_request(self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]) -> Any:
        return self._action_type.Impl.GetResultService.Request(goal_id=goal_handle.goal_id)

    def _on_result(
        self,
        handle: ClientGoalHandle[GoalT, ResultT, FeedbackT],
        answer: _Answer[Any],
        response: Future[Any],
    ) -> None:
        executor = self._node.executor
        while executor is not None and executor.serve(self._feedback):
            continue  # what was published before the end comes before the result
        error = response.exception()
        if error is None:
            handle.status = cast("Any", response.result()).status
        self._finish(handle.key)
        if error is None:
            answer.set_result(response.result())
        else:
            answer.set_exception(error)

    def get_result(self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]) -> Any:
        """Wait for a goal's result; see `ClientGoalHandle`."""
        response = self._result_client.call(self._result_request(goal_handle))
        goal_handle.status = response.status
        self._finish(goal_handle.key)
        return response

    def cancel_goal_async(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> Future[CancelGoal.Response]:
        """Ask for a goal's end; see `ClientGoalHandle`."""
        return self._cancel_client.call_async(_cancel_request(goal_handle))

    def cancel_goal(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> CancelGoal.Response:
        """Ask for a goal's end and wait for the answer; see `ClientGoalHandle`."""
        return cast("CancelGoal.Response", self._cancel_client.call(_cancel_request(goal_handle)))

    # -- what the server tells -----------------------------------------------------------------

    def _on_feedback(self, message: Any) -> Any:
        goal = self._goals.get(bytes(message.goal_id.uuid))
        if goal is None or goal.feedback_callback is None:
            return None
        return goal.feedback_callback(message)

    def _on_status(self, message: Any) -> None:
        with self._lock:
            known = dict(self._goals)
        status: GoalStatus
        for status in message.status_list:
            goal = known.pop(bytes(status.goal_info.goal_id.uuid), None)
            if goal is not None:
                goal.tell(GoalState(status.status))
        for key, goal in known.items():
            # A goal that ended, and that the server has forgotten: nobody will ask for the result.
            if goal.is_over or goal.state.is_terminal:
                self._forget(key)

    def configure_introspection(
        self,
        clock: Clock,
        service_event_qos_profile: QoSProfile | int,
        introspection_state: ServiceIntrospectionState,
    ) -> None:
        """Publish what the three services do, or publish it no longer; see `Service`."""
        for one in (self._goal_client, self._result_client, self._cancel_client):
            one.configure_introspection(clock, service_event_qos_profile, introspection_state)

    def get_num_entities(self) -> NumberOfEntities:
        """Return how many of each kind it is made of."""
        return NumberOfEntities(num_subscriptions=2, num_clients=3)

    # -- the end -------------------------------------------------------------------------------

    def destroy(self) -> None:
        """Send no more; goals that are under way are forgotten here. May be called twice."""
        for subscription in (cast("Any", self._feedback), self._status):
            self._node.destroy_subscription(subscription)
        self._answers.destroy()
        for timer in list(self._timers):
            self._drop_timer(timer)
        for client in (self._goal_client, self._result_client, self._cancel_client):
            self._node.destroy_client(client)
        with self._lock:
            self._goals.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.destroy()


def _take_no_notice(missing: int) -> None:  # noqa: ARG001 - what a subscription calls
    return


def _is_too_early(error: BaseException) -> bool:
    return isinstance(error, ServiceError) and error.kind == "no_server"


def _cancel_request(goal_handle: ClientGoalHandle[Any, Any, Any]) -> CancelGoal.Request:
    request = CancelGoal.Request()
    request.goal_info.goal_id = goal_handle.goal_id
    return request
