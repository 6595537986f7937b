"""Callbacks for changes of the parameters of any node."""

from __future__ import annotations

import threading
from itertools import chain
from typing import TYPE_CHECKING, Any

from zbot.executor.callback_check import check_callback
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
    """Handle of a callback for one parameter."""

    def __init__(
        self, parameter_name: str, node_name: str, callback: Callable[[ParameterMsg], Any]
    ) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """Handle of a callback for all events."""

    def __init__(self, callback: Callable[[ParameterEvent], Any]) -> None:
        self.callback = callback


class ParameterEventCallbacks:
    """Callbacks of a `ParameterEventHandler`, with rclpy's names.

    All methods may be called from any thread, and by the callbacks themselves.
    """

    def __init__(self) -> None:
        self.mutex = threading.Lock()
        #: A key is a parameter's name and its node's full name. The handle added last is first.
        self.parameter_callbacks: dict[tuple[str, str], list[ParameterCallbackHandle]] = {}
        self.event_callbacks: list[
            ParameterEventCallbackHandle
        ] = []  #: the handle added last is first

    def event_callback(self, event: ParameterEvent) -> None:
        """Call the callbacks for an event."""
        with self.mutex:
            of_parameters = [(*key, list(some)) for key, some in self.parameter_callbacks.items()]
            of_events = list(self.event_callbacks)
        for name, node, handles in of_parameters:
            parameter = ParameterEventHandler.get_parameter_from_event(event, name, node)
            if parameter is not None:
                for handle in handles:
                    handle.callback(parameter)
        for of_event in of_events:
            of_event.callback(event)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[ParameterMsg], Any]
    ) -> ParameterCallbackHandle:
        """Add a callback for a parameter of a node. `node_name` is the node's full name."""
        handle = ParameterCallbackHandle(parameter_name, node_name, callback)
        with self.mutex:
            self.parameter_callbacks.setdefault((parameter_name, node_name), []).insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Remove a callback, or raise `UnknownCallbackError`."""
        key = handle.parameter_name, handle.node_name
        with self.mutex:
            _remove(self.parameter_callbacks.get(key, []), handle)
            if not self.parameter_callbacks[key]:
                del self.parameter_callbacks[key]

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], Any]
    ) -> ParameterEventCallbackHandle:
        """Add a callback for all events."""
        handle = ParameterEventCallbackHandle(callback)
        with self.mutex:
            self.event_callbacks.insert(0, handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Remove a callback, or raise `UnknownCallbackError`."""
        with self.mutex:
            _remove(self.event_callbacks, handle)


def _remove(handles: list[Any], handle: Any) -> None:
    if handle not in handles:
        raise UnknownCallbackError(handle.callback)
    handles.remove(handle)


class ParameterEventHandler:
    """Subscribes to `/parameter_events` and runs callbacks, as in rclpy.

    Of the callbacks for one parameter, the handler first calls the callback that was added last.
    The callbacks for all events are called in the same order.

    Args:
        node: The node that subscribes. Its executor runs the callbacks.
        qos_profile: Profile of the subscription.
        callback_group: Group of the callbacks. `None` means the node's default group.
        event_callbacks: Callbacks for QoS events, a `SubscriptionEventCallbacks`.
        qos_overriding_options: The QoS policies that parameters may override.
        raw: Ignored, because the callbacks need decoded messages.
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
        """Destroy the subscription."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    def configure_nodes_filter(self, node_names: Sequence[str] | None = None) -> bool:
        """Select the nodes whose events the callbacks get.

        Args:
            node_names: Names as in `add_parameter_callback`, at most 100 (the limit of a content
                filter). With `None` or an empty list, the callbacks get the events of all nodes.

        Returns:
            Always true, because the filter is active as requested.

        Raises:
            ContentFilterError: There are too many names.
        """
        names = [self._resolve_path(name) for name in node_names or ()]
        expression = " OR ".join(f"node = %{i}" for i in range(len(names)))
        self.parameter_event_subscription.set_content_filter(expression, [f"'{n}'" for n in names])
        return self.parameter_event_subscription.is_cft_enabled is bool(names)

    @staticmethod
    def get_parameter_from_event(
        event: ParameterEvent, parameter_name: str, node_name: str
    ) -> ParameterMsg | None:
        """Return a node's parameter if an event declares or changes it, else `None`."""
        if event.node != node_name:
            return None
        found = ParameterEventHandler.get_parameters_from_event(event)
        return next((parameter for parameter in found if parameter.name == parameter_name), None)

    @staticmethod
    def get_parameters_from_event(event: ParameterEvent) -> Iterable[ParameterMsg]:
        """Return the parameters that an event declares or changes."""
        return chain(event.new_parameters, event.changed_parameters)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[ParameterMsg], Any]
    ) -> ParameterCallbackHandle:
        """Add a callback for declarations and changes of a parameter.

        Args:
            parameter_name: Name of the parameter.
            node_name: Name of the parameter's node. It is absolute, or relative to the namespace of
                the handler's node. An empty name means the handler's node.
            callback: Takes an rcl_interfaces/msg/Parameter.

        Returns:
            The argument for `remove_parameter_callback`.
        """
        call = "add_parameter_callback"
        check_callback(call, callback, "(parameter)", position=2, may_do_nothing=True)
        name = self._resolve_path(node_name)
        return self._callbacks.add_parameter_callback(parameter_name, name, callback)

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Remove a callback.

        Raises:
            UnknownCallbackError: The callback was not added here, or was removed already.
        """
        self._callbacks.remove_parameter_callback(handle)

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], Any]
    ) -> ParameterEventCallbackHandle:
        """Add a callback for all events of all nodes.

        Returns:
            The argument for `remove_parameter_event_callback`.
        """
        check_callback("add_parameter_event_callback", callback, "(event)")
        return self._callbacks.add_parameter_event_callback(callback)

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Remove a callback.

        Raises:
            UnknownCallbackError: The callback was not added here, or was removed already.
        """
        self._callbacks.remove_parameter_event_callback(handle)

    def _resolve_path(self, node_name: str | None = None) -> str:
        if not node_name:
            return self.node.get_fully_qualified_name()
        if node_name.startswith("/"):
            return node_name
        return fully_qualified(self.node.get_namespace(), node_name)
