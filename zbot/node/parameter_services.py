"""Services of a node to get, set, list and describe its parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces.lazy_service import LazyService
from zbot.node.service import Service
from zbot.parameters.errors import ParameterException
from zbot.parameters.parameter import Parameter
from zbot.parameters.store import prefixes_of
from zbot.qos import qos_profile_parameters
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.node.state import NodeState

#: Types and type hashes of the services, which never change in ROS 2. They are constants because
#: loading the classes would double the time to create a node, and most nodes get no request.
SERVICES = {
    "describe_parameters": (
        "rcl_interfaces/srv/DescribeParameters",
        "RIHS01_845b484d71eb0673dae682f2e3ba3c4851a65a3dcfb97bddd82c5b57e91e4cff",
    ),
    "get_parameter_types": (
        "rcl_interfaces/srv/GetParameterTypes",
        "RIHS01_da199c878688b3e530bdfe3ca8f74cb9fa0c303101e980a9e8f260e25e1c80ca",
    ),
    "get_parameters": (
        "rcl_interfaces/srv/GetParameters",
        "RIHS01_bf9803d5c74cf989a5de3e0c2e99444599a627c7ff75f97b8c05b01003675cbc",
    ),
    "list_parameters": (
        "rcl_interfaces/srv/ListParameters",
        "RIHS01_3e6062bfbb27bfb8730d4cef2558221f51a11646d78e7bb30a1e83afac3aad9d",
    ),
    "set_parameters": (
        "rcl_interfaces/srv/SetParameters",
        "RIHS01_56eed9a67e169f9cb6c1f987bc88f868c14a8fc9f743a263bc734c154015d7e0",
    ),
    "set_parameters_atomically": (
        "rcl_interfaces/srv/SetParametersAtomically",
        "RIHS01_0e192ef259c07fc3c07a13191d27002222e65e00ccec653ca05e856f79285fcd",
    ),
}


class ParameterServices:
    """The six parameter services of a node.

    Args:
        handle: The node's state.
        resolve: Returns the full, remapped name of a service.
    """

    def __init__(self, handle: NodeState, resolve: Callable[..., str]) -> None:
        self._store = handle.parameters
        for name, (type_name, type_hash) in SERVICES.items():
            full = resolve(f"{handle.full_name}/{name}", only_expand=False, is_service=True)
            named_type = (type_name, type_hash)
            service: Service[Any, Any] = Service(
                handle.context,
                LazyService(type_name),
                getattr(self, f"_{name}"),
                handle.named_endpoint(EntityKind.SERVICE, full, named_type, qos_profile_parameters),
                ready_queue=handle.ready_queue,
                callback_group=handle.default_callback_group,
                logger_name=handle.logger_name,
            )
            handle.services.append(service)
            handle.add(service)

    def _describe_parameters(self, request: Any, response: Any) -> Any:
        try:
            found = [(name, self._store.describe(name)) for name in request.names]
        except ParameterException:
            return response  # empty, as in rclpy, if one name is unknown
        response.descriptors = [
            descriptor.to_message(name if name in self._store.values else "")
            for name, descriptor in found
        ]
        return response

    def _get_parameters(self, request: Any, response: Any) -> Any:
        try:
            found = [self._store.get(name) for name in request.names]
        except ParameterException:
            return response  # empty, as in rclpy, if one name is unknown
        response.values = [parameter.get_parameter_value() for parameter in found]
        return response

    def _get_parameter_types(self, request: Any, response: Any) -> Any:
        try:
            response.types = [int(self._store.type_of(name)) for name in request.names]
        except ParameterException:
            return response  # empty, as in rclpy, if one name is unknown
        return response

    def _list_parameters(self, request: Any, response: Any) -> Any:
        names = self._store.names(request.prefixes, request.depth)
        response.result.names = names
        response.result.prefixes = list(prefixes_of(names))
        return response

    def _set_parameters(self, request: Any, response: Any) -> Any:
        for message in request.parameters:
            response.results.append(self._result([message]))
        return response

    def _set_parameters_atomically(self, request: Any, response: Any) -> Any:
        response.result = self._result(request.parameters)
        return response

    def _result(self, messages: list[Any]) -> Any:
        from rcl_interfaces.msg import SetParametersResult  # noqa: PLC0415 - the import makes the class

        try:
            parameters = [Parameter.from_parameter_msg(message) for message in messages]
        except ZbotError as error:  # the request has an invalid value
            return SetParametersResult(successful=False, reason=str(error))
        try:
            reason = self._store.set(parameters)
        except ParameterException as error:
            reason = str(error)
        return SetParametersResult(successful=not reason, reason=reason)
