"""Base class of action clients and servers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.action.generic import ActionGeneric, FeedbackT, GoalT, ResultT

if TYPE_CHECKING:
    from collections.abc import Sequence

    from typing_extensions import Self

    from zbot.executor.clock import Clock
    from zbot.node.service_introspection import ServiceIntrospectionState
    from zbot.qos import QoSProfile


class ActionEndpoint(ActionGeneric[GoalT, ResultT, FeedbackT]):
    """A client or a server of an action. The end of a `with` block destroys it."""

    _action_type: type[Any]
    _action_name: str
    _services: Sequence[Any]  # its three clients or servers

    @property
    def action_type(self) -> type[Any]:
        """The action class."""
        return self._action_type

    @property
    def action_name(self) -> str:
        """The action's full name."""
        return self._action_name

    def configure_introspection(
        self,
        clock: Clock,
        service_event_qos_profile: QoSProfile | int,
        introspection_state: ServiceIntrospectionState,
    ) -> None:
        """Configure the service events of the three services, as in `Service`."""
        for one in self._services:
            one.configure_introspection(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        """Destroy the services and topics."""
        raise NotImplementedError

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.destroy()
