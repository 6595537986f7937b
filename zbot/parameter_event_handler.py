"""Functions that are called when a parameter of any node changes."""

from __future__ import annotations

import threading
from itertools import chain
from typing import TYPE_CHECKING, Any

from zbot.names import fully_qualified
from zbot.parameter_errors import UnknownCallbackError
from zbot.qos import qos_profile_parameter_events

from rcl_interfaces.msg import ParameterEvent

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.callback_group import CallbackGroup
    from zbot.node import Node
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


class ParameterEventHandler:
    """Listens to `/parameter_events` for a node, as in rclpy.

    Of several callbacks, the one that was added last is called first.

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
        self._lock = threading.Lock()
        self._of_parameters: list[ParameterCallbackHandle] = []
        self._of_events: list[ParameterEventCallbackHandle] = []
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            self._on_event,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
        )

    def destroy(self) -> None:
        """Listen no more."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    def _on_event(self, event: ParameterEvent) -> None:
        with self._lock:
            of_parameters, of_events = list(self._of_parameters), list(self._of_events)
        for handle in of_parameters:
            name, node = handle.parameter_name, handle.node_name
            parameter = ParameterEventHandler.get_parameter_from_event(event, name, node)
            if parameter is not None:
                handle.callback(parameter)
        for one in of_events:
            one.callback(event)

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
        handle = ParameterCallbackHandle(parameter_name, self._resolved(node_name), callback)
        with self._lock:
            self._of_parameters.insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Take a callback back.

        Raises:
            UnknownCallbackError: It was not added here, or is removed already.
        """
        self._remove(self._of_parameters, handle)

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], Any]
    ) -> ParameterEventCallbackHandle:
        """Call a function with every event of every node.

        Returns:
            What `remove_parameter_event_callback` takes.
        """
        handle = ParameterEventCallbackHandle(callback)
        with self._lock:
            self._of_events.insert(0, handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Take a callback back.

        Raises:
            UnknownCallbackError: It was not added here, or is removed already.
        """
        self._remove(self._of_events, handle)

    def _remove(self, handles: list[Any], handle: Any) -> None:
        with self._lock:
            if handle not in handles:
                raise UnknownCallbackError(handle.callback)
            handles.remove(handle)

    def _resolved(self, node_name: str) -> str:
        if not node_name:
            return self.node.get_fully_qualified_name()
        if node_name.startswith("/"):
            return node_name
        return fully_qualified(self.node.get_namespace(), node_name)
