"""Parts of action clients and of servers: type parameters, base class and queue of functions."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from zbot.action.errors import NotAnActionTypeError
from zbot.executor.set_by_init import set_by_init
from zbot.executor.spinnable import check_node
from zbot.node.argument_check import check_order, is_class, is_node

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from typing_extensions import Self

    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import Clock
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.node.argument_check import Kind
    from zbot.node.service_introspection import ServiceIntrospectionState
    from zbot.qos import QoSProfile

GoalT = TypeVar("GoalT")
ResultT = TypeVar("ResultT")
FeedbackT = TypeVar("FeedbackT")


class ActionGeneric(Generic[GoalT, ResultT, FeedbackT]):
    """Base of the generic classes for actions, such as `ActionClient[Goal, Result, Feedback]`."""

    def __class_getitem__(cls, parameters: tuple[Any, ...]) -> Any:
        # Since ROS 2 Lyrical, rclpy has a fourth parameter, the action's `Impl`. zbot ignores it.
        return super().__class_getitem__(parameters[:3])  # type: ignore[misc]


def check_arguments(call: str, node: Any, action_type: Any, *arguments: tuple[Any, Kind]) -> None:
    """Check the arguments of a client or server.

    Raises:
        WrongTypeError: The arguments are in the wrong order.
        WrongObjectError: The first argument is not a node.
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
        for service in self._services:
            service.configure_introspection(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        """Destroy the services and topics."""
        raise NotImplementedError

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.destroy()


class WorkQueue:
    """Functions that wait for the executor. They may be added before the node has an executor.

    Args:
        ready_queue: The node's ready queue.
        callback_group: Decides which callbacks may run at the same time as a function.
    """

    due_ns: int | None = None

    def __init__(self, ready_queue: ReadyQueue, callback_group: CallbackGroup) -> None:
        self.ready_queue = ready_queue
        self.callback_group = callback_group
        self._functions: deque[Callable[[], Any]] = deque()
        ready_queue.add(self)

    def add(self, function: Callable[[], Any]) -> None:
        """Let the executor call a function or coroutine function. Any thread may call this."""
        self._functions.append(function)
        self.ready_queue.post(self)

    def take(self) -> Callable[[], Any] | None:
        """Return the oldest function, or `None` if no function waits."""
        try:
            return self._functions.popleft()
        except IndexError:
            return None

    def execute(self, function: Callable[[], Any]) -> Any:
        """Call the function and return its result. If this is a coroutine, the executor runs it."""
        return function()

    def destroy(self) -> None:
        """Remove this queue from the ready queue, and drop the functions that wait."""
        self.ready_queue.remove(self)
        self._functions.clear()
