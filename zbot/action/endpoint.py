"""Base class of action clients and servers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.action.errors import NotAnActionTypeError
from zbot.action.generic import ActionGeneric, FeedbackT, GoalT, ResultT
from zbot.executor.set_by_init import set_by_init
from zbot.executor.spinnable import check_node
from zbot.node.argument_check import check_order, is_class, is_node

if TYPE_CHECKING:
    from collections.abc import Sequence

    from typing_extensions import Self

    from zbot.executor.clock import Clock
    from zbot.node.argument_check import Kind
    from zbot.node.service_introspection import ServiceIntrospectionState
    from zbot.qos import QoSProfile


def check_arguments(call: str, node: Any, action_type: Any, *arguments: tuple[Any, Kind]) -> None:
    """Check the arguments of a client or server.

    Raises:
        WrongTypeError: The arguments are in the wrong order.
        NodeArgumentError: The first argument is not a node.
        NotAnActionTypeError: The second argument is not an action class.
    """
    check_order(call, (node, is_node), (action_type, is_class), *arguments)
    check_node(call, node)
    if not hasattr(action_type, "Impl"):
        raise NotAnActionTypeError(action_type)


class ActionEndpoint(ActionGeneric[GoalT, ResultT, FeedbackT]):
    """A client or a server of an action. The end of a `with` block destroys it."""

    _node: Any = set_by_init("node, action_type, 'name'")
    _action_type: type[Any] = set_by_init("node, action_type, 'name'")
    _action_name: str
    _services: Sequence[Any] = set_by_init("node, action_type, 'name'")

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
