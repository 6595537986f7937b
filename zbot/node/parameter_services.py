"""Services of a node to get, set, list and describe its parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces.registry import LazyService
from zbot.node.service import Service
from zbot.node.service_types import PARAMETER_SERVICES
from zbot.parameters.errors import ParameterException
from zbot.parameters.parameter import Parameter
from zbot.parameters.store import prefixes_of
from zbot.qos import qos_profile_parameters
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.node.entities import NodeEntities


class ParameterServices:
    """The six parameter services of a node.

    Args:
        node: The node. Its executor runs the callbacks.
    """

    def __init__(self, node: NodeEntities) -> None:
        handle = node.handle
        self._store = handle.parameters
        for name, (type_name, type_hash) in PARAMETER_SERVICES.items():
            full = handle.resolve(f"{handle.full_name}/{name}", is_service=True)
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
