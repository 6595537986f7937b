"""Operations on services: calls by a client, and services that a client serves."""

from __future__ import annotations

import itertools
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.executor.task import Future
from zbot.interfaces import type_name
from zbot.interfaces.plain_value import json_value
from zbot.observer.serving.client_budget import MAX_CALLS
from zbot.web.rosbridge import rosapi
from zbot.web.rosbridge.bridge import ClientFailedError
from zbot.web.rosbridge.client_message import RosbridgeError
from zbot.web.rosbridge.json_message import message_from_json
from zbot.web.rosbridge.session import UnknownHereError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.shared_entities import EntityReference
    from zbot.web.rosbridge.client_message import ClientMessage
    from zbot.web.rosbridge.session import Session

#: The largest number of services that one client may serve.
MAX_SERVICES = 100
#: Longest wait for a response if the call has no field `timeout`, in seconds.
DEFAULT_TIMEOUT_S = 10.0
_numbers = itertools.count(1)


class ServiceOperations:
    """Calls and services of one client.

    Args:
        session: The client's session.

    Attributes:
        operations: The operations by name.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._calls: set[_Call] = set()
        self._served: dict[str, _ServedService] = {}
        self.operations: dict[str, Callable[[ClientMessage], None]] = {
            "call_service": self._call,
            "advertise_service": self._advertise,
            "unadvertise_service": self._unadvertise,
            "service_response": self._respond,
        }

    def close(self) -> None:
        """End the client's services. Ignore later responses to the client's own calls."""
        for service in self._served.values():
            service.close()
        self._session.waiting_threads.close()
        for call in tuple(self._calls):
            call.end()

    def _call(self, message: ClientMessage) -> None:
        name = message.word("service")
        call = _Call(self._session, message, name, self._calls)
        is_full = len(self._calls) >= MAX_CALLS
        self._calls.add(call)
        if is_full:
            call.fail(f"you wait for {MAX_CALLS} responses already")
            return
        try:
            call.start()
        except UnknownHereError:
            call.end()  # it starts again in a thread that may ask the nodes
            raise
        except Exception as error:  # noqa: BLE001 - the client gets an answer in any case
            call.fail(self._session.bridge.sentence(error))

    def _advertise(self, message: ClientMessage) -> None:
        self._session.require_writable("serving")
        bridge = self._session.bridge
        name = bridge.node.resolve_service_name(message.word("service"))
        service_type = self._session.interface("srv", message.word("type"))
        known = self._served.pop(name, None)
        if known is not None:
            known.close()
        elif len(self._served) >= MAX_SERVICES:
            raise RosbridgeError(f"a client can serve {MAX_SERVICES} services")
        given = message.word("service")
        self._served[name] = _ServedService(self._session, given, name, service_type)
        self._session.report("info", f"{name} is advertised", message)

    def _unadvertise(self, message: ClientMessage) -> None:
        service = self._find(message)
        del self._served[service.name]
        service.close()

    def _respond(self, message: ClientMessage) -> None:
        self._find(message).respond(message)

    def _find(self, message: ClientMessage) -> _ServedService:
        name = self._session.bridge.node.resolve_service_name(message.word("service"))
        service = self._served.get(name)
        if service is None:
            raise RosbridgeError(f"you do not serve {name}")
        return service


class _Call:
    """Call of a service by the client. The client gets one answer: the response or an error."""

    def __init__(
        self, session: Session, message: ClientMessage, name: str, calls: set[_Call]
    ) -> None:
        self._session = session
        self._message = message
        self._name = name
        self._calls = calls
        self._form = (
            message.word("compression", "none"),
            int(message.number("fragment_size", 0)) or None,
        )
        self._client: EntityReference[Any] | None = None
        self._stop_timeout: Callable[[], None] | None = None

    def start(self) -> None:
        bridge = self._session.bridge
        # Old programs append `#` and the call's id to the name.
        name = bridge.node.resolve_service_name(self._name.partition("#")[0])
        types = dict(bridge.graph().services()).get(name, [])
        procedure = None if types else rosapi.PROCEDURES.get(name)
        args = self._message.get("args")
        if procedure is not None:
            self._session.waiting_threads.submit(self._run, procedure, args)
            return
        self._session.require_writable("calling services")
        if len(types) != 1:
            raise RosbridgeError(f"there is no service {name}" if not types else _two_types(name))
        service_type = self._session.interface("srv", types[0])
        request = message_from_json(
            service_type.Request, {} if args is None else args, bridge.now, self._message.size
        )
        self._client = bridge.shared.get(
            ("client", name, types[0]),
            lambda: bridge.node.create_client(service_type, name),
            bridge.node.destroy_client,
        )
        timeout_s = self._message.number("timeout", DEFAULT_TIMEOUT_S, least=-1e9)
        if timeout_s > 0:
            text = f"{name} did not answer within {timeout_s:g} s"
            self._stop_timeout = self._session.call_later(timeout_s, partial(self.fail, text))
        self._client.entity.call_server_async(request).add_done_callback(self._finish)

    def _run(self, procedure: rosapi.Procedure, args: Any) -> None:
        try:
            values = procedure(self._session.bridge, rosapi.arguments(args))
        except Exception as error:  # noqa: BLE001 - as above
            self.fail(self._session.bridge.sentence(error))
        else:
            self._answer(values, is_success=True)

    def _finish(self, future: Future[Any]) -> None:
        error = future.exception()
        if error is not None or future.cancelled():
            self.fail(str(error or "the call was cancelled"))
        else:
            self._answer(json_value(future.result()), is_success=True)

    def fail(self, text: str) -> None:
        """Answer with an error. If there was an answer before, do nothing."""
        self._answer(text, is_success=False)

    def _answer(self, values: Any, *, is_success: bool) -> None:
        if not self.end():
            return
        self._session.send(
            {
                "op": "service_response",
                "id": self._message.id,
                "service": self._name,
                "values": values,
                "result": is_success,
            },
            *self._form,
        )

    def end(self) -> bool:
        """Forget the call. Return False if it was forgotten before."""
        try:
            self._calls.remove(self)
        except KeyError:
            return False  # another thread was faster, e.g. a response came at the timeout
        if self._stop_timeout is not None:
            self._stop_timeout()  # a timeout of hours would keep the call in memory
        if self._client is not None and self._session.bridge.node.context.ok():
            self._client.release()
        return True


def _two_types(name: str) -> str:
    return f"several nodes serve {name}, with different types"


class _ServedService:
    """Service whose requests the client answers."""

    def __init__(self, session: Session, given: str, name: str, service_type: Any) -> None:
        self._session = session
        self._given = given  #: the name as the client wrote it; the client finds its callback by it
        self.name = name
        self._type = service_type
        self._futures: dict[str, Future[Any]] = {}
        node = session.bridge.node
        self._service = node.create_service(service_type, name, self._handle)

    async def _handle(self, request: Any, _response: Any) -> Any:
        if len(self._futures) >= MAX_CALLS:
            raise ClientFailedError(f"{self.name} has {MAX_CALLS} unanswered requests")
        future: Future[Any] = Future()
        id_ = f"service_request:{self.name}:{next(_numbers)}"
        self._futures[id_] = future
        try:
            self._session.send(
                {
                    "op": "call_service",
                    "id": id_,
                    "service": self._given,
                    "type": type_name(self._type),
                    "args": json_value(request),
                }
            )
            return await future
        finally:
            self._futures.pop(id_, None)

    def respond(self, message: ClientMessage) -> None:
        future = self._futures.get(str(message.id))
        if future is None:
            raise RosbridgeError(f"no request of {self.name} has the id {message.id!r}")
        values = message.get("values")
        if not message.flag("result", default=True):
            reason = values if isinstance(values, str) else "the web program reports a failure"
            future.set_exception(ClientFailedError(f"{self.name} failed: {reason}"))
            return
        values = {} if values is None else values
        try:
            response = message_from_json(
                self._type.Response, values, self._session.bridge.now, message.size
            )
        except RosbridgeError as error:
            text = f"{self.name} sent a wrong response: {error}"
            future.set_exception(ClientFailedError(text))
            raise
        future.set_result(response)

    def close(self) -> None:
        """End the service. Callers that wait get an error."""
        for future in tuple(self._futures.values()):
            future.set_exception(ClientFailedError(f"{self.name} has ended"))
        node = self._session.bridge.node
        if node.context.ok():
            node.destroy_service(self._service)
