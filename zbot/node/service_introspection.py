"""Service events: messages about each step of a service call, for debugging."""

from __future__ import annotations

from dataclasses import replace
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, type_hash
from zbot.node.endpoint import Endpoint
from zbot.node.publisher import Publisher
from zbot.qos import QoSProfile, as_profile
from zbot.wire.attachment import GID_LENGTH, NUMBER
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import Clock
    from zbot.wire.tokens import EndpointToken


class ServiceIntrospectionState(IntEnum):
    """Content of the service events of a server or client, with rclpy's names."""

    OFF = 0
    METADATA = 1  #: kind and time of the event, number of the call and gid of the client
    CONTENTS = 2  #: also the request or the response


class Step(IntEnum):
    """Steps of a call, with the numbers of `service_msgs/msg/ServiceEventInfo`."""

    REQUEST_SENT = 0
    REQUEST_RECEIVED = 1
    RESPONSE_SENT = 2
    RESPONSE_RECEIVED = 3


class Introspection:
    """Publishes the events of a server or client on `<service>/_service_event`.

    Args:
        context: The context whose session sends the events.
        endpoint: The server or client.
        clock: The clock for the events' stamps.
        qos: Profile to publish with.
        with_contents: Whether the events contain requests and responses.
    """

    def __init__(
        self,
        context: Context,
        endpoint: ServiceEndpoint,
        clock: Clock,
        qos: QoSProfile | int,
        *,
        with_contents: bool,
    ) -> None:
        self._clock = clock
        self._with_contents = with_contents
        event_type: Any = getattr(endpoint.srv_type, "Event", None)
        if event_type is None:
            event_type = get_interface(f"{endpoint.token.type_name}_Event")
        self._event_type = event_type
        self._info_type = get_interface("service_msgs/msg/ServiceEventInfo")
        token = _event_token(context, endpoint.token, type_hash(event_type), as_profile(qos))
        self._publisher: Publisher[Any] = Publisher(
            context,
            event_type,
            token,
            logger_name=endpoint.logger_name,
            callback_group=endpoint.callback_group,
        )

    def report(self, step: Step, call: bytes, *, request: Any = None, response: Any = None) -> None:
        """Publish an event. Nothing happens after the context was shut down.

        Args:
            step: The step of the call.
            call: Bytes that begin with the call's number and end with the client's gid. They are
                empty if the call is unknown.
            request: The request, if it was sent or received in this step.
            response: The response, if it was sent or received in this step.
        """
        if not self._publisher.is_open:
            return
        info = self._info_type(event_type=step, stamp=self._clock.now().to_msg())
        if call:
            info.sequence_number = NUMBER.unpack_from(call)[0]
            info.client_gid = list(call[-GID_LENGTH:])
        event = self._event_type(info=info)
        if self._with_contents:
            event.request = [] if request is None else [request]
            event.response = [] if response is None else [response]
        self._publisher.publish(event)

    def destroy(self) -> None:
        """Leave the topic. This method may be called twice."""
        self._publisher.destroy()


class ServiceEndpoint(Endpoint):
    """Base class of servers and clients, which can publish the events of a service."""

    srv_type: Any
    callback_group: CallbackGroup
    _introspection: Introspection | None = None

    @property
    def service_name(self) -> str:
        """The service's full name."""
        return self._token.name

    def configure_introspection(
        self,
        clock: Clock,
        service_event_qos_profile: QoSProfile | int,
        introspection_state: ServiceIntrospectionState,
    ) -> None:
        """Start or stop publishing service events on `<service>/_service_event`.

        Args:
            clock: The clock for the events' stamps.
            service_event_qos_profile: Profile to publish with.
            introspection_state: `OFF`, `METADATA` or `CONTENTS`. With `CONTENTS`, the events
                contain requests and responses.
        """
        self.end_introspection()
        if introspection_state != ServiceIntrospectionState.OFF:
            self._introspection = Introspection(
                self._context,
                self,
                clock,
                service_event_qos_profile,
                with_contents=introspection_state == ServiceIntrospectionState.CONTENTS,
            )

    def end_introspection(self) -> None:
        """Stop publishing service events. Nothing happens if no events are published."""
        introspection, self._introspection = self._introspection, None
        if introspection is not None:
            introspection.destroy()


def _event_token(
    context: Context, owner: EndpointToken, hash_text: str, qos: QoSProfile
) -> EndpointToken:
    token = replace(
        owner,
        eid=0,
        kind=EntityKind.PUBLISHER,
        name=f"{owner.name}/_service_event",
        type_name=f"{owner.type_name}_Event",
        type_hash=hash_text,
        qos=qos,
    )
    return context.dialect.with_key(context.graph.numbers.numbered(token))
