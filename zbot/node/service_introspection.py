"""Events that tell others of each step of a service call, for those who look for a mistake."""

from __future__ import annotations

from enum import IntEnum
from struct import Struct
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, type_hash
from zbot.node.endpoint import Endpoint
from zbot.node.publisher import Publisher
from zbot.qos import QoSProfile, as_profile
from zbot.wire.attachment import GID_LENGTH
from zbot.wire.tokens import EndpointToken, EntityKind

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import Clock

_NUMBER = Struct("<q")  # how an attachment begins


class ServiceIntrospectionState(IntEnum):
    """How much a server or client tells (rclpy's names)."""

    OFF = 0
    METADATA = 1  #: that something happened, when, and in which call
    CONTENTS = 2  #: requests and responses too


class Step(IntEnum):
    """What happens in a call; the numbers are those of `service_msgs/msg/ServiceEventInfo`."""

    REQUEST_SENT = 0
    REQUEST_RECEIVED = 1
    RESPONSE_SENT = 2
    RESPONSE_RECEIVED = 3


class Introspection:
    """Publishes a server's or a client's events on `<service>/_service_event`.

    Args:
        context: The session to publish through.
        endpoint: The server or client.
        clock: Gives the events' stamps.
        qos: Profile to publish with.
        with_contents: Whether requests and responses are part of the events.
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
        """Publish an event; nothing happens once the context is shut down.

        Args:
            step: What happened.
            call: Begins with the call's number and ends with the client's gid; empty if unknown.
            request: The request, if this step is about it.
            response: The response, likewise.
        """
        if not self._publisher.is_open:
            return
        info = self._info_type(event_type=step, stamp=self._clock.now().to_msg())
        if call:
            info.sequence_number = _NUMBER.unpack_from(call)[0]
            info.client_gid = list(call[-GID_LENGTH:])
        event = self._event_type(info=info)
        if self._with_contents:
            event.request = [] if request is None else [request]
            event.response = [] if response is None else [response]
        self._publisher.publish(event)

    def destroy(self) -> None:
        """Leave the topic; may be called twice."""
        self._publisher.destroy()


class ServiceEndpoint(Endpoint):
    """What a server and a client have in common: a service, and events that tell of its calls."""

    srv_type: Any
    callback_group: CallbackGroup
    _context: Context
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
        """Publish what happens here on `<service>/_service_event`, or publish it no longer.

        Args:
            clock: Gives the events' stamps.
            service_event_qos_profile: Profile to publish with.
            introspection_state: `OFF`, `METADATA`, or `CONTENTS` for requests and responses too.
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
        """Publish what happens here no longer; nothing happens if nothing is published."""
        introspection, self._introspection = self._introspection, None
        if introspection is not None:
            introspection.destroy()


def _event_token(
    context: Context, owner: EndpointToken, hash_text: str, qos: QoSProfile
) -> EndpointToken:
    return EndpointToken(
        domain=owner.domain,
        zid=owner.zid,
        nid=owner.nid,
        eid=context.next_entity_id(),
        kind=EntityKind.PUBLISHER,
        namespace=owner.namespace,
        node=owner.node,
        enclave=owner.enclave,
        name=f"{owner.name}/_service_event",
        type_name=f"{owner.type_name}_Event",
        type_hash=hash_text,
        qos=qos,
    )
