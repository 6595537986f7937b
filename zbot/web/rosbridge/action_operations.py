"""Operations on actions: goals that a client sends, and actions that a client serves."""

from __future__ import annotations

import itertools
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.action import ActionClient, ActionServer, CancelResponse
from zbot.action.goal_state import GoalState
from zbot.executor.task import Future
from zbot.interfaces import type_name
from zbot.interfaces.plain_value import json_value
from zbot.web.rosbridge.client_message import RosbridgeError
from zbot.web.rosbridge.json_message import message_from_json
from zbot.web.rosbridge.session import UnknownHereError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.shared_entities import EntityReference
    from zbot.web.rosbridge.client_message import ClientMessage
    from zbot.web.rosbridge.session import Session

#: The largest number of unfinished goals that a client may send. Each action that the client serves
#: has the same limit of goals that are executed at the same time.
MAX_GOALS = 100
#: The largest number of actions that one client may serve.
MAX_ACTIONS = 50
#: Longest wait for the server to accept or reject a goal, in seconds.
ACCEPT_TIMEOUT_S = 10.0
_numbers = itertools.count(1)


class ActionOperations:
    """Goals and action servers of one client.

    Args:
        session: The client's session.

    Attributes:
        operations: The operations by name.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._goals: dict[str | int, _SentGoal] = {}
        self._served: dict[str, _ServedAction] = {}
        self.operations: dict[str, Callable[[ClientMessage], None]] = {
            "send_action_goal": self._send_goal,
            "cancel_action_goal": self._cancel_goal,
            "advertise_action": self._advertise,
            "unadvertise_action": self._unadvertise,
            "action_feedback": self._on_feedback,
            "action_result": self._on_result,
        }

    def close(self) -> None:
        """End the client's actions. Goals that the client has sent continue, without an answer."""
        for action in self._served.values():
            action.close()
        for goal in tuple(self._goals.values()):
            goal.end()

    def _send_goal(self, message: ClientMessage) -> None:
        key = f"goal {next(_numbers)}" if message.id is None else message.id
        if key in self._goals:
            raise RosbridgeError(f"you have a goal with the id {key!r} already")
        goal = _SentGoal(self._session, message, self._goals, key)
        if len(self._goals) >= MAX_GOALS:
            goal.refuse(f"you have {MAX_GOALS} goals already")
            return
        self._goals[key] = goal
        try:
            goal.start()
        except UnknownHereError:
            goal.end()  # it starts again in a thread that may ask the nodes
            raise
        except Exception as error:  # noqa: BLE001 - the client gets an answer in any case
            goal.fail(self._session.bridge.sentence(error))

    def _cancel_goal(self, message: ClientMessage) -> None:
        goal = None if message.id is None else self._goals.get(message.id)
        if goal is None:
            raise RosbridgeError(f"you have no goal with the id {message.id!r}")
        goal.cancel()

    def _advertise(self, message: ClientMessage) -> None:
        self._session.require_writable("serving")
        bridge = self._session.bridge
        given = message.word("action")
        name = bridge.node.resolve_service_name(given)
        action_type = self._session.interface("action", message.word("type"))
        known = self._served.pop(name, None)
        if known is not None:
            known.close()
        elif len(self._served) >= MAX_ACTIONS:
            raise RosbridgeError(f"a client can serve {MAX_ACTIONS} actions")
        self._served[name] = _ServedAction(self._session, given, name, action_type)
        self._session.report("info", f"{name} is advertised", message)

    def _unadvertise(self, message: ClientMessage) -> None:
        self._find(message).close()
        del self._served[self._session.bridge.node.resolve_service_name(message.word("action"))]

    def _on_feedback(self, message: ClientMessage) -> None:
        self._find(message).publish_feedback(message)

    def _on_result(self, message: ClientMessage) -> None:
        self._find(message).finish(message)

    def _find(self, message: ClientMessage) -> _ServedAction:
        name = self._session.bridge.node.resolve_service_name(message.word("action"))
        action = self._served.get(name)
        if action is None:
            raise RosbridgeError(f"you do not serve {name}")
        return action


class _SentGoal:
    """Goal that the client sends. The client gets one answer: the result or an error."""

    def __init__(
        self,
        session: Session,
        message: ClientMessage,
        goals: dict[str | int, _SentGoal],
        key: str | int,
    ) -> None:
        self._session = session
        self._message = message
        self._name = message.word("action")
        self._goals = goals
        self._key = key
        self._form = (
            message.word("compression", "none"),
            int(message.number("fragment_size", 0)) or None,
        )
        self._client: EntityReference[Any] | None = None
        self._handle: Any = None
        self._stop_timeout: Callable[[], None] | None = None
        self._is_cancel_wanted = False

    def start(self) -> None:
        self._session.require_writable("sending goals")
        bridge = self._session.bridge
        action_type = self._session.interface("action", self._message.word("action_type"))
        args = self._message.get("args")
        goal = message_from_json(
            action_type.Goal, {} if args is None else args, bridge.now, self._message.size
        )
        name = bridge.node.resolve_service_name(self._name)
        self._client = bridge.shared.get(
            ("action", name, type_name(action_type)),
            lambda: ActionClient(bridge.node, action_type, name),
            ActionClient.destroy,
        )
        wants_feedback = self._message.flag("feedback")
        text = f"{name} did not answer within {ACCEPT_TIMEOUT_S:g} s"
        self._stop_timeout = self._session.call_later(ACCEPT_TIMEOUT_S, partial(self._expire, text))
        future = self._client.entity.send_goal_to_server_async(
            goal, self._on_feedback if wants_feedback else None
        )
        future.add_done_callback(self._on_accepted)

    def _on_accepted(self, future: Future[Any]) -> None:
        error = future.exception()
        if error is not None:
            self.fail(str(error))
            return
        handle: Any = future.result()
        if not handle.accepted:
            self.fail("the server has rejected the goal")
            return
        self._handle = handle
        handle.get_result_async().add_done_callback(self._on_result)
        if self._is_cancel_wanted:
            handle.cancel_goal_async()

    def cancel(self) -> None:
        self._is_cancel_wanted = True
        if self._handle is not None:
            self._handle.cancel_goal_async()

    def _on_feedback(self, message: Any) -> None:
        if self._goals.get(self._key) is self:
            self._send({"op": "action_feedback", "values": json_value(message.feedback)})

    def _on_result(self, future: Future[Any]) -> None:
        error = future.exception()
        if error is not None:
            self.fail(str(error))
            return
        response: Any = future.result()
        if self.end():
            self._answer(json_value(response.result), response.status, is_success=True)

    def _expire(self, text: str) -> None:
        if self._handle is None:
            self.fail(text)

    def fail(self, text: str) -> None:
        """End the goal, and answer with an error. A goal that has ended gets no second answer."""
        if self.end():
            self.refuse(text)

    def refuse(self, text: str) -> None:
        """Answer with an error for a goal that was not kept."""
        self._answer(text, GoalState.UNKNOWN.value, is_success=False)

    def _answer(self, values: Any, status: int, *, is_success: bool) -> None:
        self._send(
            {"op": "action_result", "values": values, "status": status, "result": is_success}
        )

    def _send(self, fields: dict[str, Any]) -> None:
        self._session.send({**fields, "id": self._message.id, "action": self._name}, *self._form)

    def end(self) -> bool:
        """Forget the goal. Return False if it was forgotten before."""
        if self._goals.get(self._key) is not self or self._goals.pop(self._key, None) is None:
            return False  # another thread was faster
        if self._stop_timeout is not None:
            self._stop_timeout()  # the timeout would keep the goal in memory
        if self._client is not None and self._session.bridge.node.context.ok():
            self._client.release()
        return True


class _ServedAction:
    """Action whose goals the client executes."""

    def __init__(self, session: Session, given: str, name: str, action_type: Any) -> None:
        self._session = session
        self._given = given  #: the name as the client wrote it; the client finds its callback by it
        self._name = name
        self._type = action_type
        self._goals: dict[str, tuple[Any, Future[Any]]] = {}
        self._server: ActionServer[Any, Any, Any] = ActionServer(
            session.bridge.node,
            action_type,
            name,
            self._execute,
            cancel_callback=self._cancel,
        )

    async def _execute(self, goal_handle: Any) -> Any:
        if len(self._goals) >= MAX_GOALS:
            goal_handle.abort()
            return self._type.Result()
        future: Future[Any] = Future()
        id_ = f"action_goal:{self._name}:{next(_numbers)}"
        self._goals[id_] = (goal_handle, future)
        try:
            self._send(
                "send_action_goal",
                id_,
                action_type=type_name(self._type),
                args=json_value(goal_handle.request),
                feedback=True,
            )
            if goal_handle.is_cancel_requested:
                self._send("cancel_action_goal", id_)  # the request came before the goal was kept
            outcome: Any = await future
        finally:
            del self._goals[id_]
        status, result = outcome
        if status == GoalState.SUCCEEDED.value:
            goal_handle.succeed()
        elif status == GoalState.CANCELED.value and goal_handle.is_cancel_requested:
            goal_handle.canceled()
        else:
            goal_handle.abort()
        return result

    def _cancel(self, goal_handle: Any) -> CancelResponse:
        for id_, (known, _) in tuple(self._goals.items()):
            if known is goal_handle:
                self._send("cancel_action_goal", id_)
        return CancelResponse.ACCEPT

    def _send(self, op: str, id_: str, **fields: Any) -> None:
        self._session.send({"op": op, "id": id_, "action": self._given, **fields})

    def publish_feedback(self, message: ClientMessage) -> None:
        goal_handle, _ = self._goal(message)
        now = self._session.bridge.now
        goal_handle.publish_feedback(
            message_from_json(self._type.Feedback, message.get("values"), now, message.size)
        )

    def finish(self, message: ClientMessage) -> None:
        _, future = self._goal(message)
        if not message.flag("result", default=True):
            future.set_result((GoalState.ABORTED.value, self._type.Result()))
            return
        status = int(message.number("status", GoalState.SUCCEEDED.value, most=127))
        values = message.get("values")
        now = self._session.bridge.now
        try:
            result = message_from_json(
                self._type.Result, {} if values is None else values, now, message.size
            )
        except RosbridgeError:
            future.set_result((GoalState.ABORTED.value, self._type.Result()))
            raise
        future.set_result((status, result))

    def _goal(self, message: ClientMessage) -> tuple[Any, Future[Any]]:
        found = self._goals.get(str(message.id))
        if found is None:
            raise RosbridgeError(f"no goal of {self._name} has the id {message.id!r}")
        return found

    def close(self) -> None:
        """End the action. Its goals are aborted."""
        for _, future in tuple(self._goals.values()):
            future.set_result((GoalState.ABORTED.value, self._type.Result()))
        if self._session.bridge.node.context.ok():
            self._server.destroy()
