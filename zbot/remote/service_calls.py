"""Calls of other nodes' services, with a time limit for each answer."""

from __future__ import annotations

import contextlib
import threading
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.threads.deadline import Deadline
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from zbot.executor.task import Future
    from zbot.graph.snapshot import Snapshot
    from zbot.node.client import Client
    from zbot.node.node import Node

ANSWER_TIMEOUT_S = 5.0  #: for each answer, as in ros2


class NoServiceError(ZbotError):
    """No node offers a service."""

    def __init__(self, name: str) -> None:
        self.name = name
        super().__init__(f"no node offers the service {name}")


class NoAnswerError(ZbotError, TimeoutError):
    """A service did not answer in time."""

    def __init__(self, name: str, timeout_s: float) -> None:
        self.name, self.timeout_s = name, timeout_s
        super().__init__(f"{name} did not answer within {timeout_s:g} s: its node is busy or stuck")


@dataclass(slots=True)
class Answers:
    """Answers of several nodes, and the errors of the nodes without an answer."""

    found: dict[str, Any] = field(default_factory=dict)
    errors: dict[str, ZbotError] = field(default_factory=dict)


class ServiceCalls:
    """Caller of other nodes' services. A client exists only during its call.

    Any thread may call the methods. The node of this caller need not spin.

    Args:
        node: The node that sends the requests.
        answer_timeout_s: Seconds to wait for an answer. `None` means no limit.
        server_timeout_s: Seconds to wait for a server that is not running yet. 0 means that a
            service which the graph does not show is an error at once.
    """

    def __init__(
        self,
        node: Node,
        *,
        answer_timeout_s: float | None = ANSWER_TIMEOUT_S,
        server_timeout_s: float = 0.0,
    ) -> None:
        self._node = node
        self._answer_timeout_s = answer_timeout_s
        self._server_timeout_s = server_timeout_s

    def call(self, name: str, srv_type: type[Any], request: Any) -> Any:
        """Call a service and return the response.

        Raises:
            NoServiceError: No node offers the service.
            NoAnswerError: The answer did not come in time.
            ServiceError: The server ended before it answered, or its callback failed.
        """
        with self._client(name, srv_type, self._graph()) as client:
            try:
                return client.call(request, self._answer_timeout_s)
            except TimeoutError:
                raise NoAnswerError(name, self._answer_timeout_s or 0.0) from None

    def call_all(self, srv_type: type[Any], requests: Mapping[str, Any]) -> Answers:
        """Call services of one type at the same time.

        The thread must not be that of an executor which runs one of the servers.

        Args:
            srv_type: The service class.
            requests: The requests by the names of the services. The answers have the same keys.
        """
        answers, graph = Answers(), self._graph()
        with contextlib.ExitStack() as stack:
            sent: dict[str, Future[Any]] = {}
            for name, request in requests.items():
                try:
                    client = stack.enter_context(self._client(name, srv_type, graph))
                    sent[name] = client.call_server_async(request)
                except ZbotError as error:
                    answers.errors[name] = error
            self._collect(sent, answers)
        return answers

    def _collect(self, sent: Mapping[str, Future[Any]], answers: Answers) -> None:
        deadline = Deadline(self._answer_timeout_s)
        for name, future in sent.items():
            is_over = threading.Event()
            future.add_waker(is_over.set)
            try:
                if not is_over.wait(deadline.left_s):
                    raise NoAnswerError(name, self._answer_timeout_s or 0.0)
                answers.found[name] = future.result()
            except ZbotError as error:
                answers.errors[name] = error

    def _graph(self) -> Snapshot | None:
        """Return the graph, or `None` if the calls wait for servers that start later.

        In a command, this asks all sessions, so it is done once for all calls.
        """
        return None if self._server_timeout_s > 0 else self._node.context.graph.snapshot()

    @contextlib.contextmanager
    def _client(
        self, name: str, srv_type: type[Any], graph: Snapshot | None
    ) -> Iterator[Client[Any, Any]]:
        client = self._node.create_client(srv_type, name)
        try:
            is_expected = graph is None or graph.on(client.service_name, EntityKind.SERVICE)
            limit_s = self._server_timeout_s or self._answer_timeout_s
            if not (is_expected and client.wait_for_service(limit_s)):
                raise NoServiceError(name)
            yield client
        finally:
            self._node.destroy_client(client)
