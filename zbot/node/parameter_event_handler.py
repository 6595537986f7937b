"""Functions that are called when a parameter of any node changes."""

from __future__ import annotations

import threading
from itertools import chain
from typing import TYPE_CHECKING, Any

from zbot.names import fully_qualified
from zbot.parameters.errors import UnknownCallbackError
from zbot.qos import qos_profile_parameter_events

from rcl_interfaces.msg import ParameterEvent

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from zbot.executor.callback_group import CallbackGroup
    from zbot.node.node import Node
    from zbot.qos import QoSProfile

    from rcl_interfaces.msg import Parameter as ParameterMsg


class ParameterCallbackHandle:
    """Stands for one callback of one parameter."""

    def __init__(
        self, parameter_name: str, node_name: str, callback: Callable[[ParameterMsg], Any]
    ) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """Stands for one callback of every change."""

    def __init__(self, callback: Callable[[ParameterEvent], Any]) -> None:
        self.callback = callback


class ParameterEventCallbacks:
    """The callbacks of a handler, under the names that rclpy gives them.

    All methods may be called from any thread, and by the callbacks themselves.
    """

    def __init__(self) -> None:
        self.mutex = threading.Lock()
        #: By the parameter's name and the node's full name; each list begins with the latest.
        self.parameter_callbacks: dict[tuple[str, str], list[ParameterCallbackHandle]] = {}
        self.event_callbacks: list[ParameterEventCallbackHandle] = []  #: begins with the latest

    def event_callback(self, event: ParameterEvent) -> None:
        """Call those whom an event concerns."""
        with self.mutex:
            of_parameters = [(*key, list(some)) for key, some in self.parameter_callbacks.items()]
            of_events = list(self.event_callbacks)
        for name, node, handles in of_parameters:
            parameter = ParameterEventHandler.get_parameter_from_event(event, name, node)
            if parameter is not None:
                for handle in handles:
                    handle.callback(parameter)
        for one in of_events:
            one.callback(event)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[ParameterMsg], Any]
    ) -> ParameterCallbackHandle:
        """Call a function for a parameter of a node, which is given by its full name."""
        handle = ParameterCallbackHandle(parameter_name, node_name, callback)
        with self.mutex:
            self.parameter_callbacks.setdefault((parameter_name, node_name), []).insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Take a callback back, or raise `UnknownCallbackError`."""
        key = handle.parameter_name, handle.node_name
        with self.mutex:
            _remove(self.parameter_callbacks.get(key, []), handle)
            if not self.parameter_callbacks[key]:
                del self.parameter_callbacks[key]

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], Any]
    ) -> ParameterEventCallbackHandle:
        """Call a function for every event."""
        handle = ParameterEventCallbackHandle(callback)
        with self.mutex:
            self.event_callbacks.insert(0, handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Take a callback back, or raise `UnknownCallbackError`."""
        with self.mutex:
            _remove(self.event_callbacks, handle)


def _remove(handles: list[Any], handle: Any) -> None:
    if handle not in handles:
        raise UnknownCallbackError(handle.callback)
    handles.remove(handle)


class ParameterEventHandler:
    """Listens to `/parameter_events` for a node, as in rclpy.

    Of several callbacks of a parameter, or of every event, the one added last is called first.

    Args:
        node: Subscribes and runs the callbacks.
        qos_profile: Of the subscription.
        callback_group: Decides beside what the callbacks may run; the node's own if left out.
        event_callbacks: A `SubscriptionEventCallbacks`.
        qos_overriding_options: Which policies parameters may override.
        raw: Accepted; callbacks need the message.
    """

    def __init__(  # noqa: PLR0917 - rclpy's signature
        self,
        node: Node,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,  # noqa: ARG002 - see the docstring
    ) -> None:
        self.node = node
        self.qos_profile = qos_profile
        self._callbacks = ParameterEventCallbacks()
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            self._callbacks.event_callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
        )

    def destroy(self) -> None:
        """Listen no more."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    def configure_nodes_filter(self, node_names: Sequence[str] | None = None) -> bool:
        """Take only the events of some nodes from now on, or those of all nodes again.

        Args:
            node_names: As in `add_parameter_callback`, at most 100 (what a content filter holds);
                none or an empty list for all nodes.

        Returns:
            True: the events are filtered as asked.

        Raises:
            ContentFilterError: There are too many.
        """
        names = [self._resolve_path(name) for name in node_names or ()]
        expression = " OR ".join(f"node = %{i}" for i in range(len(names)))
        self.parameter_event_subscription.set_content_filter(expression, [f"'{n}'" for n in names])
        return self.parameter_event_subscription.is_cft_enabled is bool(names)

    @staticmethod
    def get_parameter_from_event(
        event: ParameterEvent, parameter_name: str, node_name: str
    ) -> ParameterMsg | None:
        """Return a node's parameter if an event says that it is new or changed."""
        if event.node != node_name:
            return None
        found = ParameterEventHandler.get_parameters_from_event(event)
        return next((one for one in found if one.name == parameter_name), None)

    @staticmethod
    def get_parameters_from_event(event: ParameterEvent) -> Iterable[ParameterMsg]:
        """Return the parameters that are new or changed."""
        return chain(event.new_parameters, event.changed_parameters)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[ParameterMsg], Any]
    ) -> ParameterCallbackHandle:
        """Call a function with a parameter whenever it is declared or set.

        Args:
            parameter_name: Which parameter.
            node_name: Of which node: an absolute name, one relative to the namespace of the
                handler's node, or an empty one for that node itself.
            callback: Takes an rcl_interfaces/msg/Parameter.

        Returns:
            What `remove_parameter_callback` takes.
        """
        name = self._resolve_path(node_name)
        return self._callbacks.add_parameter_callback(parameter_name, name, callback)

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Take a callback back.

        Raises:
            UnknownCallbackError: It was not added here, or is removed already.
        """
        self._callbacks.remove_parameter_callback(handle)

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], Any]
    ) -> ParameterEventCallbackHandle:
        """Call a function with every event of every node.

        Returns:
            What `remove_parameter_event_callback` takes.
        """
        return self._callbacks.add_parameter_event_callback(callback)

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Take a callback back.

        Raises:
            UnknownCallbackError: It was not added here, or is removed already.
        """
        self._callbacks.remove_parameter_event_callback(handle)

    def _resolve_path(self, node_name: str | None = None) -> str:
        if not node_name:
            return self.node.get_fully_qualified_name()
        if node_name.startswith("/"):
            return node_name
        return fully_qualified(self.node.get_namespace(), node_name)
