"""Clients that call services and actions with the requests in a bag."""

from __future__ import annotations

import contextlib
import uuid
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.errors import NotInitializedError
from zbot.interfaces import get_service

if TYPE_CHECKING:
    from zbot.executor.task import Future
    from zbot.node.node import Node

    #: For the recorded id of each goal: the new id, and the server's response to the goal.
    Goals: TypeAlias = dict[bytes, tuple[bytes, Future[Any]]]

_EVENT_TYPE = "_Event"
_REQUEST_SENT, _REQUEST_RECEIVED = 0, 1  # constants of service_msgs/msg/ServiceEventInfo


class RequestPublisher:
    """Client that sends the request in each recorded event of a service.

    Args:
        node: The node that calls. Its executor handles the responses.
        service: Name of the service.
        event_type: Type of the events, e.g. `std_srvs/srv/SetBool_Event`.
        is_of_clients: Whether to send the requests in events of clients, not of servers.

    Raises:
        UnknownPackageError: The service's type is not known here.
        UnknownInterfaceError: The service's type is not known here, but its package is known.
    """

    def __init__(self, node: Node, service: str, event_type: str, *, is_of_clients: bool) -> None:
        cls: Any = get_service(event_type.removesuffix(_EVENT_TYPE))
        self._log = node.get_logger()
        self._service = service
        self._client = node.create_client(cls, service)
        self._kind = _REQUEST_SENT if is_of_clients else _REQUEST_RECEIVED
        self._is_warned = False

    def wait_for_server(self, timeout_s: float) -> None:
        """Wait until a server is discovered, at most `timeout_s` seconds."""
        self._client.wait_for_service(max(timeout_s, 0))

    def publish(self, event: Any) -> None:
        """Call the service if the event has a request. The response is not used."""
        if event.info.event_type != self._kind:
            return
        if not event.request:
            self._warn(
                f"the events of service '{self._service}' have no requests: they were recorded "
                "with metadata only"
            )
        elif not self._client.service_is_ready():
            self._warn(f"no request is sent to service '{self._service}': it is not running")
        else:
            self._send(event.request[0])

    def _send(self, request: Any) -> None:
        self._client.call_server_async(request)

    def _warn(self, text: str) -> None:
        if not self._is_warned:
            self._is_warned = True
            self._log.error(text)


class GoalPublisher(RequestPublisher):
    """Client that sends the recorded requests of one of an action's services.

    Each goal gets a new id, because a server refuses an id that it knows. A request about a goal,
    e.g. to cancel the goal, is sent when the server has accepted the goal.

    Args:
        node: The node that calls. Its executor handles the responses.
        service: Name of the service.
        event_type: Type of the events, e.g. `action_msgs/srv/CancelGoal_Event`.
        goals: The goals that were sent. All publishers of an action share this dictionary.
        is_of_clients: Whether to send the requests in events of clients, not of servers.

    Raises:
        UnknownPackageError: The service's type is not known here.
        UnknownInterfaceError: The service's type is not known here, but its package is known.
    """

    def __init__(
        self, node: Node, service: str, event_type: str, goals: Goals, *, is_of_clients: bool
    ) -> None:
        super().__init__(node, service, event_type, is_of_clients=is_of_clients)
        self._goals = goals
        self._sends_goals = event_type.endswith("_SendGoal_Event")

    def _send(self, request: Any) -> None:
        goal_id = request.goal_info.goal_id if hasattr(request, "goal_info") else request.goal_id
        recorded = bytes(goal_id.uuid)
        if self._sends_goals:
            goal_id.uuid = list(uuid.uuid4().bytes)
            self._goals[recorded] = bytes(goal_id.uuid), self._client.call_server_async(request)
        elif recorded in self._goals:
            new, response = self._goals[recorded]
            goal_id.uuid = list(new)
            response.add_done_callback(lambda done: self._send_if_accepted(done, request))
        else:
            self._warn(f"no request is sent to service '{self._service}': its goal was not sent")

    def _send_if_accepted(self, response: Future[Any], request: Any) -> None:
        answer = None if response.exception() else response.result()
        if answer is not None and answer.accepted:
            with contextlib.suppress(NotInitializedError):  # the playback has ended
                super()._send(request)
