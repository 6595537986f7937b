"""Client for the parameters of another node."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.parameters.parameter import Parameter, parameter_dict_from_yaml_file
from zbot.qos import qos_profile_parameter_events, qos_profile_services_default
from zbot.remote.parameters import parameter_messages
from zbot.threads.deadline import Deadline

from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.task import Future
    from zbot.node.client import Client
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription
    from zbot.qos import QoSProfile

    from rcl_interfaces.msg import Parameter as ParameterMsg

    Callback = Callable[[Future[Any]], Any] | None


class AsyncParameterClient:
    """Client for the parameters of another node. Its methods return futures of responses.

    Args:
        node: The node that sends the requests.
        remote_node_name: The other node's name, absolute or relative to the namespace of `node`.
        qos_profile: Profile of the six clients. The graph shows the profile. The profile has no
            other effect.
        callback_group: Group of the callbacks. `None` means the node's default group.
    """

    def __init__(
        self,
        node: Node,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        self.node = node
        self.remote_node_name = remote_node_name
        self._clients: list[Client[Any, Any]] = []

        def client(srv_type: type[Any], name: str) -> Client[Any, Any]:
            made = node.create_client(
                srv_type,
                f"{remote_node_name}/{name}",
                qos_profile=qos_profile,
                callback_group=callback_group,
            )
            self._clients.append(made)
            return made

        self._list = client(ListParameters, "list_parameters")
        self._get = client(GetParameters, "get_parameters")
        self._get_types = client(GetParameterTypes, "get_parameter_types")
        self._describe = client(DescribeParameters, "describe_parameters")
        self._set = client(SetParameters, "set_parameters")
        self._set_atomically = client(SetParametersAtomically, "set_parameters_atomically")

    def services_are_ready(self) -> bool:
        """Return whether the other node offers all six parameter services."""
        return all(client.service_is_ready() for client in self._clients)

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Wait until the other node offers all six parameter services.

        Args:
            timeout_sec: Seconds to wait. `None` means no limit.

        Returns:
            Whether the node offers all of the services.
        """
        deadline = Deadline(timeout_sec)
        for client in self._clients:
            if not client.wait_for_service(deadline.left_s):
                return False
        return self.services_are_ready()

    def list_parameters(
        self,
        prefixes: list[str] | None = None,
        depth: int | None = None,
        callback: Callback = None,
    ) -> Future[Any]:
        """Get the names of parameters. By default, get the names in all groups and levels."""
        request = ListParameters.Request(prefixes=prefixes or [], depth=depth or 0)
        return _sent(self._list, request, callback)

    def get_parameters(self, names: list[str], callback: Callback = None) -> Future[Any]:
        """Get values. If a name is unknown, the response has no values."""
        return _sent(self._get, GetParameters.Request(names=names), callback)

    def get_parameter_types(self, names: list[str], callback: Callback = None) -> Future[Any]:
        """Get the types of the values, as numbers of `Parameter.Type`."""
        return _sent(self._get_types, GetParameterTypes.Request(names=names), callback)

    def describe_parameters(self, names: list[str], callback: Callback = None) -> Future[Any]:
        """Get the descriptors of parameters."""
        return _sent(self._describe, DescribeParameters.Request(names=names), callback)

    def set_parameters(
        self, parameters: Sequence[Parameter[Any] | ParameterMsg], callback: Callback = None
    ) -> Future[Any]:
        """Set parameters one after the other. The response has a result for each parameter."""
        return _sent(
            self._set, SetParameters.Request(parameters=parameter_messages(parameters)), callback
        )

    def set_parameters_atomically(
        self, parameters: Sequence[Parameter[Any] | ParameterMsg], callback: Callback = None
    ) -> Future[Any]:
        """Set all of the parameters or none of them. The response has one result."""
        request = SetParametersAtomically.Request(parameters=parameter_messages(parameters))
        return _sent(self._set_atomically, request, callback)

    def delete_parameters(self, names: list[str], callback: Callback = None) -> Future[Any]:
        """Undeclare parameters. This works only for parameters with a dynamic type."""
        return self.set_parameters([Parameter(name) for name in names], callback)

    def load_parameter_file(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callback = None
    ) -> Future[Any]:
        """Set the parameters that a file has for the other node, one after the other.

        Args:
            parameter_file: Path of the YAML file.
            use_wildcard: Whether the part `/**` of the file applies too.
            callback: Called when the future is done.

        Raises:
            ParametersFileError: The file cannot be read, or is not a parameter file.
            WrongStateError: The file has no parameters for the other node.
        """
        return self.set_parameters(self._loaded(parameter_file, use_wildcard), callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callback = None
    ) -> Future[Any]:
        """Set all parameters that a file has for the other node, or none of them."""
        return self.set_parameters_atomically(self._loaded(parameter_file, use_wildcard), callback)

    def _loaded(self, path: str, use_wildcard: bool) -> list[ParameterMsg]:
        nodes = [self.remote_node_name]
        return list(parameter_dict_from_yaml_file(path, use_wildcard, target_nodes=nodes).values())

    def on_parameter_event(
        self,
        callback: Callable[..., Any],
        qos_profile: QoSProfile = qos_profile_parameter_events,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
    ) -> Subscription[ParameterEvent]:
        """Subscribe to `/parameter_events`, where each node publishes changes of its parameters."""
        return self.node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )


def _sent(client: Client[Any, Any], request: Any, callback: Callback) -> Future[Any]:
    future = client.call_async(request)
    if callback is not None:
        future.add_done_callback(callback)
    return future
