"""Side of a bridge that uses ROS 2's own rclpy, which usually uses DDS."""

from __future__ import annotations

import importlib
import threading
import time
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.bridge.errors import CallError
from zbot.bridge.rclpy_graph import RclpyGraph, to_genuine
from zbot.bridge.rclpy_import import genuine_class, import_rclpy
from zbot.bridge.rclpy_loop import Loop, Waiting
from zbot.bridge.sender_filter import SenderFilter
from zbot.bridge.side import NODE_PREFIX, End, World

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.bridge.routes import Log
    from zbot.bridge.side import Answer, Format
    from zbot.qos import QoSProfile

_GRAPH_S = 0.2
_NO_SERVER_S = 3.0
# Largest number of messages that are taken from a topic before it is the turn of other topics.
_BATCH = 100
_GONE = "the node in ROS 2 that has the service is gone"
_NO_SERVER = f"no node in ROS 2 has had the service for {_NO_SERVER_S:g} s"


class RclpySide:
    """Side of a bridge that uses ROS 2's own rclpy.

    Args:
        bridge_id: The bridge's id, a part of the node's name.
        domain: ROS 2's domain, 0 to 232.
        log: Gets a line when a message cannot be published.
        on_error: Called with an unexpected exception, after which the side does not work.

    Raises:
        BridgeError: This Python cannot import a genuine rclpy.
    """

    label = "ROS 2"
    format: Format = "cdr"

    def __init__(
        self, bridge_id: str, domain: int, log: Log, on_error: Callable[[Exception], None]
    ) -> None:
        self.rclpy = import_rclpy()
        self.qos: Any = importlib.import_module("rclpy.qos")
        self.serialization: Any = importlib.import_module("rclpy.serialization")
        self.log = log
        signals = importlib.import_module("rclpy.signals")
        self._context = importlib.import_module("rclpy.context").Context()
        self.rclpy.init(
            args=[],
            context=self._context,
            domain_id=domain,
            signal_handler_options=signals.SignalHandlerOptions.NO,
        )
        self.node: Any = self.rclpy.create_node(
            NODE_PREFIX + bridge_id,
            context=self._context,
            use_global_arguments=False,
            enable_rosout=False,
            start_parameter_services=False,
        )
        self._changed: Callable[[], None] = lambda: None
        self.graph = RclpyGraph(self.node)
        self.graph.update()
        self._tickers: list[Callable[[], None]] = []
        self.loop = Loop(self.rclpy, self._context, self._tick, _GRAPH_S, on_error)
        self.loop.start()

    def _tick(self) -> None:
        if self.graph.update():
            self._changed()
        for tick in list(self._tickers):
            tick()

    def at_tick(self, tick: Callable[[], None]) -> None:
        """Call a function in the loop's thread, after each look at the graph."""
        self._tickers.append(tick)

    def not_at_tick(self, tick: Callable[[], None]) -> None:
        """Stop calling a function."""
        if tick in self._tickers:
            self._tickers.remove(tick)

    def watch(self, changed: Callable[[], None]) -> None:
        """Call a function after each change of the graph, in the loop's thread."""
        self._changed = changed

    def world(self) -> World:
        """Return the nodes and endpoints that no bridge has made."""
        return self.graph.world

    def lack(self, type_name: str) -> str:
        """Return why ROS 2 has no class of a type here, or ""."""
        if genuine_class(type_name) is None:
            package = type_name.partition("/")[0]
            return f"this Python has no {type_name} of ROS 2 (install the package {package})"
        return ""

    def receiver(
        self, name: str, type_name: str, qos: QoSProfile, receive: Callable[[bytes], None]
    ) -> _Receiver:
        """Subscribe to a topic."""
        return _Receiver(self, name, _class(type_name), to_genuine(self.qos, qos), receive)

    def sender(self, name: str, type_name: str, qos: QoSProfile) -> _Sender:
        """Return a publisher of bytes."""
        return _Sender(self, name, _class(type_name), to_genuine(self.qos, qos))

    def server(
        self, name: str, type_name: str, node: str, serve: Callable[[bytes, Answer], None]
    ) -> _Server:
        """Offer a service. In the graph of ROS 2, the service belongs to the bridge's node."""
        del node
        return _Server(self, name, _class(type_name), serve)

    def caller(self, name: str, type_name: str) -> _Caller:
        """Return a client of a service."""
        return _Caller(self, name, _class(type_name))

    def show(self, nodes: frozenset[str], ends: frozenset[End]) -> None:
        """Do nothing: a node of ROS 2 cannot show other nodes."""

    def close(self) -> None:
        """End the thread and leave ROS 2."""
        self.loop.close()
        self.node.destroy_node()
        self._context.try_shutdown()


def _class(type_name: str) -> type[Any]:
    found = genuine_class(type_name)
    if found is None:
        raise LookupError(type_name)  # the caller must ask `lack()` first
    return found


class _Receiver:
    """Subscription whose messages the loop takes as bytes."""

    def __init__(
        self,
        side: RclpySide,
        name: str,
        message_class: type[Any],
        qos: Any,
        receive: Callable[[bytes], None],
    ) -> None:
        self._side, self._class = side, message_class
        self._senders = SenderFilter(name, side.graph.is_of_bridge, receive, side.log)
        self._entity = side.node.create_subscription(
            message_class, name, _ignore, qos, raw=True, event_callbacks=_events("Subscription")
        )
        self._take_message = self._entity.handle.take_message
        self._waiting = Waiting("subscription", self._entity.handle, self._take)
        side.loop.add(self._waiting)
        side.at_tick(self._senders.release)

    def _take(self) -> None:
        for _ in range(_BATCH):
            taken = self._take_message(self._class, True)
            if taken is None:
                return
            data, info = taken
            self._senders.take(info["publisher_gid"]["data"], data)

    def close(self) -> None:
        """Leave the topic."""
        self._side.not_at_tick(self._senders.release)
        destroy = partial(self._side.node.destroy_subscription, self._entity)
        self._side.loop.remove(self._waiting, destroy)


class _Sender:
    """Publisher of bytes."""

    is_heard = True

    def __init__(self, side: RclpySide, name: str, message_class: type[Any], qos: Any) -> None:
        self._side, self._name = side, name
        self._entity = side.node.create_publisher(
            message_class, name, qos, event_callbacks=_events("Publisher")
        )
        self._publish = self._entity.handle.publish_raw
        self._is_closed = False
        self.failed_count = 0

    def send(self, data: bytes) -> None:
        """Publish a message."""
        try:
            self._publish(data)
        except Exception as error:  # noqa: BLE001 - the classes of these errors are private
            self._note(error)

    def _note(self, error: Exception) -> None:
        if self._is_closed:
            return
        self.failed_count += 1
        if self.failed_count == 1:
            self._side.log.warning(
                f"{self._name}: ROS 2 refuses a message: {error} "
                "(more errors of this topic are not logged)"
            )

    def close(self) -> None:
        """Leave the topic."""
        self._is_closed = True
        self._side.loop.call_soon(partial(self._side.node.destroy_publisher, self._entity))


class _Server:
    """Server of a service. It passes requests on as bytes."""

    def __init__(
        self,
        side: RclpySide,
        name: str,
        service_class: Any,
        serve: Callable[[bytes, Answer], None],
    ) -> None:
        self.side, self.name, self.service_class, self._serve = side, name, service_class, serve
        self._entity = side.node.create_service(service_class, name, _ignore)
        self.handle = self._entity.handle
        self._waiting = Waiting("service", self.handle, self._take)
        side.loop.add(self._waiting)

    def _take(self) -> None:
        try:
            request, header = self.handle.service_take_request(self.service_class.Request)
        except Exception as error:  # noqa: BLE001 - the classes of these errors are private
            self.side.log.warning(f"{self.name}: cannot read a request of ROS 2: {error}")
            return
        if header is not None:
            data = self.side.serialization.serialize_message(request)
            self._serve(data, _RclpyAnswer(self, header.request_id))

    def close(self) -> None:
        """Stop offering the service."""
        destroy = partial(self.side.node.destroy_service, self._entity)
        self.side.loop.remove(self._waiting, destroy)


class _RclpyAnswer:
    """Answer to a request that came from ROS 2."""

    def __init__(self, server: _Server, request_id: Any) -> None:
        self._server, self._request_id = server, request_id

    def reply(self, data: bytes) -> None:
        """Send the response in the loop's thread, because this thread also destroys the server."""
        self._server.side.loop.call_soon(partial(self._reply, data))

    def _reply(self, data: bytes) -> None:
        server = self._server
        try:
            response = server.side.serialization.deserialize_message(
                data, server.service_class.Response
            )
            server.handle.service_send_response(response, self._request_id)
        except Exception as error:  # noqa: BLE001 - the classes of these errors are private
            server.side.log.warning(f"{server.name}: ROS 2 does not take a response: {error}")

    def fail(self, error: CallError) -> None:
        """Log the error, because a service of ROS 2 cannot send an error to its client."""
        self._server.side.log.warning(
            f"{self._server.name}: a node of ROS 2 called this service, and the call failed, so "
            f"the node gets no answer: {error.message}"
        )


class _Caller:
    """Client of a service of ROS 2."""

    def __init__(self, side: RclpySide, name: str, service_class: Any) -> None:
        self._side, self._name, self._class = side, name, service_class
        self._lock = threading.Lock()
        self._pending: dict[int, Answer] = {}
        self._unsent: list[tuple[float, bytes, Answer]] = []
        self._entity = side.node.create_client(service_class, name)
        self._handle = self._entity.handle
        self._waiting = Waiting("client", self._handle, self._take)
        side.loop.add(self._waiting)
        side.at_tick(self._check)

    def call(self, request: bytes, answer: Answer) -> None:
        """Send a request as soon as the server is found."""
        with self._lock:
            self._unsent.append((time.monotonic(), request, answer))
        self._side.loop.call_soon(self._check)

    def _check(self) -> None:
        """Send the requests that wait for the server. If the server is gone, let calls fail."""
        if not self._pending and not self._unsent:
            return
        if self._handle.service_server_is_available():
            with self._lock:
                unsent, self._unsent = self._unsent, []
            for _, request, answer in unsent:
                self._send(request, answer)
            return
        pending, self._pending = self._pending, {}
        for answer in pending.values():
            answer.fail(CallError("server_gone", _GONE))
        late_s = time.monotonic() - _NO_SERVER_S
        with self._lock:
            late = [unsent for unsent in self._unsent if unsent[0] < late_s]
            self._unsent = [unsent for unsent in self._unsent if unsent[0] >= late_s]
        for _, _, answer in late:
            answer.fail(CallError("no_server", _NO_SERVER))

    def _send(self, request: bytes, answer: Answer) -> None:
        try:
            message = self._side.serialization.deserialize_message(request, self._class.Request)
            self._pending[self._handle.send_request(message)] = answer
        except Exception as error:  # noqa: BLE001 - the classes of these errors are private
            answer.fail(CallError("error", f"ROS 2 does not take the request: {error}"))

    def _take(self) -> None:
        try:
            header, response = self._handle.take_response(self._class.Response)
        except Exception as error:  # noqa: BLE001 - as above
            self._side.log.warning(f"{self._name}: cannot read a response of ROS 2: {error}")
            return
        if header is None:
            return
        answer = self._pending.pop(header.request_id.sequence_number, None)
        if answer is not None:
            answer.reply(self._side.serialization.serialize_message(response))

    def close(self) -> None:
        """Leave the service. Calls without a response fail."""
        self._side.not_at_tick(self._check)
        self._side.loop.remove(self._waiting, self._destroy)

    def _destroy(self) -> None:
        answers = [*self._pending.values(), *(unsent[2] for unsent in self._unsent)]
        self._pending, self._unsent = {}, []
        for answer in answers:
            answer.fail(CallError("server_gone", _GONE))
        self._side.node.destroy_client(self._entity)


def _events(kind: str) -> Any:
    """Return an object without callbacks for events, because the bridge logs mismatches itself."""
    events = importlib.import_module("rclpy.event_handler")
    return getattr(events, f"{kind}EventCallbacks")(use_default_callbacks=False)


def _ignore(*_: object) -> None:
    """Do nothing: the loop takes the data itself."""
